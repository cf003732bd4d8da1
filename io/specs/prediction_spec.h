#pragma once
#include <string>

#include "io/files/error.h"
#include "io/json/json.h"
#include "lensmodel/words.h"

namespace sturm {

/// How a picture is predicted without lens sampling.
enum class PredictionKind {
  Ellipses,  ///< one sharp layer spread by ellipses, hidden surfaces guessed; naked eye in `camera` gaze
  Layered,   ///< ellipses of every surface that the pupil sees, hidden ones found by rays; any eye and gaze
  Multipass  ///< passes through points of the pupil, blended; any eye and gaze
};

inline constexpr Words<PredictionKind, 3> prediction_kind_words{{{PredictionKind::Ellipses, "ellipses"},
                                                                 {PredictionKind::Layered, "layered"},
                                                                 {PredictionKind::Multipass, "multipass"}}};

/// The word for it in documents.
inline std::string name_of(PredictionKind kind) {
  return std::string(prediction_kind_words.word_of(kind));
}

struct PredictionSpec {
  PredictionKind kind = PredictionKind::Ellipses;
  int passes = 64;       ///< through points of the pupil (multipass)
  bool smooth = true;    ///< filter the noise of the sharp view (layered and multipass)
  int oversampling = 1;  ///< sharp pixels per output pixel along each side
};

/// Reads "prediction", "passes", "smooth" and "oversampling" of an object. Throws InputError where they do not fit
/// together.
PredictionSpec read_prediction(const Json& value, const Source& where);

}  // namespace sturm
