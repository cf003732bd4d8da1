#pragma once
#include <string>
#include <string_view>

#include "io/json/record.h"
#include "io/specs/pupil_sampling_spec.h"
#include "io/specs/ray_bundle_spec.h"
#include "lensmodel/ray_model.h"

namespace sturm {

/// Words of the enumerations that records of studies have among their members.
template <>
struct WordOf<RayModel> {
  static std::string_view word(RayModel model) { return ray_model_words.word_of(model); }
  static std::optional<RayModel> value(std::string_view word) { return ray_model_words.value_of(word); }
};

template <>
struct WordOf<PupilSampling> {
  static std::string_view word(PupilSampling sampling) { return pupil_sampling_words.word_of(sampling); }
  static std::optional<PupilSampling> value(std::string_view word) { return pupil_sampling_words.value_of(word); }
};

template <>
struct WordOf<Sequence> {
  static std::string_view word(Sequence sequence) { return sequence_words.word_of(sequence); }
  static std::optional<Sequence> value(std::string_view word) { return sequence_words.value_of(word); }
};

/// The word of a value that a report may lack; "" then.
template <StoredWord T>
std::string word_of(const std::optional<T>& value) {
  return value ? std::string(WordOf<T>::word(*value)) : std::string();
}

}  // namespace sturm
