#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/json/suggest.h"
#include "lensmodel/words.h"

namespace sturm {

/// The value of the word that stands in a document. Throws InputError for a word that is none of them, which the schema
/// of a validated document has refused before.
template <class Enum, std::size_t count>
Enum read_word(const Json& value, const Source& where, const Words<Enum, count>& words) {
  if (value.is_string())
    if (const auto known = words.value_of(value.get_ref<const std::string&>())) return *known;
  where.fail(value, one_of(words.all()));
}

/// The same for a list of words.
template <class Enum, std::size_t count>
std::vector<Enum> read_words(const Json& list, const Source& where, const Words<Enum, count>& words) {
  std::vector<Enum> values;
  for (std::size_t i = 0; i < list.size(); ++i) values.push_back(read_word(list[i], where / i, words));
  return values;
}

/// The same for a member that may be absent.
template <class Enum, std::size_t count>
Enum word_or(const Json& object, const char* key, Enum otherwise, const Source& where,
             const Words<Enum, count>& words) {
  const auto member = object.find(key);
  return member == object.end() ? otherwise : read_word(*member, where / key, words);
}

}  // namespace sturm
