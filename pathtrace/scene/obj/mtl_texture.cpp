#include "pathtrace/scene/obj/mtl_texture.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "pathtrace/scene/obj/obj_words.h"

namespace sturm {
namespace {

struct Option {
  std::string_view word;
  int least, most;  ///< words behind it
  bool numbers;     ///< they are numbers
};

constexpr Option options[] = {{"-s", 1, 3, true},      {"-o", 1, 3, true},          {"-t", 1, 3, true},
                              {"-mm", 1, 2, true},     {"-bm", 1, 1, true},         {"-boost", 1, 1, true},
                              {"-texres", 1, 2, true}, {"-blendu", 1, 1, false},    {"-blendv", 1, 1, false},
                              {"-cc", 1, 1, false},    {"-clamp", 1, 1, false},     {"-imfchan", 1, 1, false},
                              {"-type", 1, 1, false},  {"-colorspace", 1, 1, false}};

constexpr std::size_t most_options = 16, most_readings = 64;  // a text with more is no honest one

const Option* option_of(std::string_view word) {
  const std::string lower = lower_case(word);
  const auto* at =
      std::find_if(std::begin(options), std::end(options), [&](const Option& o) { return o.word == lower; });
  return at == std::end(options) ? nullptr : at;
}

struct StatedOption {
  const Option* option;
  std::vector<std::string> words;
};

/// One way to read the text.
struct Reading {
  std::vector<StatedOption> options;
  std::string_view name;
};

bool is_on(const std::string& word) {
  const std::string lower = lower_case(word);
  return lower == "on" || lower == "true" || lower == "1";
}

/// All ways to read a text that begins with options, the one that gives them most words first.
void read_options(std::string_view text, const Reading& before, std::vector<Reading>& readings) {
  std::string_view rest = text;
  const Option* option = option_of(take_word(rest));
  if (!option || before.options.size() == most_options) {
    readings.push_back({before.options, trimmed(text)});
    return;
  }
  std::vector<std::string_view> rests;
  Reading with = before;
  with.options.push_back({option, {}});
  for (int i = 0; i < option->most; ++i) {
    std::string_view ahead = rest;
    const std::string_view word = take_word(ahead);
    if (word.empty() || (option->numbers && !number_of(word))) break;
    with.options.back().words.emplace_back(word);
    rest = ahead;
    rests.push_back(rest);
  }
  if (static_cast<int>(rests.size()) < option->least) {
    readings.push_back({before.options, trimmed(text)});
    return;
  }
  for (std::size_t count = rests.size();
       count >= static_cast<std::size_t>(option->least) && readings.size() < most_readings; --count) {
    with.options.back().words.resize(count);
    read_options(rests[count - 1], with, readings);
  }
}

/// The same with options behind the name.
void read_options_at_the_end(const Reading& reading, std::vector<Reading>& readings) {
  constexpr int most_places = 8;
  std::size_t at = 0;
  for (int place = 0; place < most_places && (at = reading.name.find(" -", at + 1)) != std::string_view::npos;
       ++place) {
    std::vector<Reading> behind;
    read_options(trimmed(reading.name.substr(at)), reading, behind);
    for (Reading& more : behind)
      if (more.name.empty()) readings.push_back({more.options, trimmed(reading.name.substr(0, at))});
  }
}

std::vector<Reading> ways_to_read(std::string_view text) {
  std::vector<Reading> readings;
  read_options(text, {}, readings);
  const std::size_t in_front = readings.size();
  for (std::size_t i = 0; i < in_front; ++i) read_options_at_the_end(Reading(readings[i]), readings);
  const std::size_t with_comment = readings.size();
  for (std::size_t i = 0; i < with_comment; ++i)
    if (const std::string_view bare = without_comment(readings[i].name); bare != readings[i].name)
      readings.push_back({readings[i].options, bare});
  readings.push_back({{}, trimmed(text)});
  return readings;
}

/// Three numbers of an option, what is not stated being `otherwise`.
Eigen::Vector3d three_numbers(const StatedOption& stated, double otherwise) {
  Eigen::Vector3d numbers = Eigen::Vector3d::Constant(otherwise);
  for (std::size_t i = 0; i < stated.words.size() && i < 3; ++i)
    numbers[static_cast<Eigen::Index>(i)] = *number_of(stated.words[i]);
  return numbers;
}

void apply(const StatedOption& stated, MtlTexture& texture) {
  const std::string_view word = stated.option->word;
  const auto leave_out = [&] { texture.left_out.emplace_back(word); };
  if (word == "-s" || word == "-o") {
    const Eigen::Vector3d numbers = three_numbers(stated, word == "-s" ? 1.0 : 0.0);
    if (!numbers.allFinite()) return leave_out();
    (word == "-s" ? texture.scale : texture.offset) = numbers.head<2>().cast<float>();
  } else if (word == "-clamp") {
    texture.clamped = is_on(stated.words[0]);
  } else if (word == "-imfchan") {
    texture.channel = lower_case(stated.words[0])[0];
  } else if (word == "-t") {
    if (!three_numbers(stated, 0.0).isZero(0.0)) leave_out();
  } else if (word == "-mm") {
    const Eigen::Vector3d numbers = three_numbers(stated, 1.0);  // base and gain
    if (numbers[0] != 0.0 || numbers[1] != 1.0) leave_out();
  } else if (word == "-blendu" || word == "-blendv") {
    if (!is_on(stated.words[0])) leave_out();
  } else if (word == "-cc") {
    if (is_on(stated.words[0])) leave_out();
  } else {
    leave_out();
  }
}

}  // namespace

MtlTexture read_mtl_texture(const std::string& text, const NamedFiles& files) {
  const std::vector<Reading> readings = ways_to_read(text);
  const Reading* taken = &readings.front();
  std::optional<NamedFiles::Found> found;
  // A file of the whole name in another folder is a worse guess than options and a name in its place.
  for (const bool elsewhere : {false, true})
    for (const Reading& reading : readings)
      if (!found)
        if (const auto at = files.find(reading.name); at && at->elsewhere == elsewhere) {
          found = at;
          taken = &reading;
        }
  MtlTexture texture;
  texture.name = taken->name;
  texture.found = found;
  for (const StatedOption& stated : taken->options) apply(stated, texture);
  return texture;
}

}  // namespace sturm
