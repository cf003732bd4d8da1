#pragma once
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sturm {

/// The values of an enumeration with the words that documents have for them. Each value and each word stands in it
/// once.
template <class Enum, std::size_t count>
struct Words {
  struct Entry {
    Enum value;
    std::string_view word;
  };
  Entry entries[count];

  /// The value of a word; none if there is no such word.
  constexpr std::optional<Enum> value_of(std::string_view word) const {
    for (const Entry& entry : entries)
      if (entry.word == word) return entry.value;
    return std::nullopt;
  }

  constexpr std::string_view word_of(Enum value) const {
    for (const Entry& entry : entries)
      if (entry.value == value) return entry.word;
    throw std::logic_error("a value without a word");
  }

  /// All words, in their order.
  std::vector<std::string> all() const {
    std::vector<std::string> words;
    for (const Entry& entry : entries) words.emplace_back(entry.word);
    return words;
  }
};

}  // namespace sturm
