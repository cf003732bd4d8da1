#include "io/specs/notation_tokens.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

#include "io/files/lower_case.h"
#include "io/files/number_text.h"
#include "io/files/readable_text.h"
#include "io/files/text_encoding.h"
#include "io/json/suggest.h"

namespace sturm {

namespace {

using namespace std::string_view_literals;

constexpr std::size_t longest_text = 400;

struct Word {
  std::string_view text;
  Term term;
};

constexpr Word words[] = {
    {"od", Term::right_eye},
    {"re", Term::right_eye},
    {"r", Term::right_eye},
    {"right", Term::right_eye},
    {"ra", Term::right_eye},
    {"rechts", Term::right_eye},
    {"os", Term::left_eye},
    {"le", Term::left_eye},
    {"l", Term::left_eye},
    {"left", Term::left_eye},
    {"la", Term::left_eye},
    {"links", Term::left_eye},
    {"oi", Term::left_eye},
    {"og", Term::left_eye},
    {"ou", Term::both_eyes},
    {"both", Term::both_eyes},
    {"sph", Term::sphere},
    {"sphere", Term::sphere},
    {"spherical", Term::sphere},
    {"s", Term::sphere},
    {"cyl", Term::cylinder},
    {"cylinder", Term::cylinder},
    {"zyl", Term::cylinder},
    {"zylinder", Term::cylinder},
    {"c", Term::cylinder},
    {"ds", Term::spheres_unit},
    {"dsph", Term::spheres_unit},
    {"dc", Term::cylinders_unit},
    {"dcyl", Term::cylinders_unit},
    {"d", Term::dioptres},
    {"dpt", Term::dioptres},
    {"dptr", Term::dioptres},
    {"diopters", Term::dioptres},
    {"dioptres", Term::dioptres},
    {"diopter", Term::dioptres},
    {"dioptre", Term::dioptres},
    {"x", Term::axis},
    {"ax", Term::axis},
    {"axis", Term::axis},
    {"axe", Term::axis},
    {"achse", Term::axis},
    {"a", Term::axis},
    {"@", Term::meridian},
    {"deg", Term::degrees},
    {"degree", Term::degrees},
    {"degrees", Term::degrees},
    {"grad", Term::degrees},
    {"add", Term::addition},
    {"addition", Term::addition},
    {"vd", Term::vertex_distance},
    {"bvd", Term::vertex_distance},
    {"vertex", Term::vertex_distance},
    {"hsa", Term::vertex_distance},
    {"mm", Term::millimetres},
    {"^", Term::prism},
    {"prism", Term::prism},
    {"prisms", Term::prism},
    {"prisma", Term::prism},
    {"pr", Term::prism},
    {"pd", Term::prism},
    {"pdpt", Term::prism},
    {"base", Term::base},
    {"basis", Term::base},
    {"bas", Term::base},
    {"b", Term::base},
    {"in", Term::base_in},
    {"bi", Term::base_in},
    {"nasal", Term::base_in},
    {"innen", Term::base_in},
    {"out", Term::base_out},
    {"bo", Term::base_out},
    {"temporal", Term::base_out},
    {"aussen", Term::base_out},
    {"up", Term::base_up},
    {"bu", Term::base_up},
    {"oben", Term::base_up},
    {"down", Term::base_down},
    {"bd", Term::base_down},
    {"unten", Term::base_down},
    {"rx", Term::filler},
    {"eye", Term::filler},
    {"and", Term::filler},
    {"with", Term::filler},
    {"distance", Term::filler},
};

constexpr std::array planos = {"pl"sv, "plano"sv, "plan"sv, "pln"sv};

/// What is typed with other than ASCII characters, in ASCII.
constexpr std::array<std::pair<std::string_view, std::string_view>, 22> spellings{{
    {"\u00D7", " x "}, {"\u2715", " x "},   {"\u2716", " x "},   {"\u2A2F", " x "},
    {"\u2573", " x "}, {"\u0445", " x "},  // Cyrillic
    {"\u00E0", " x "},                     // French: "-0,50 à 90°"
    {"*", " x "},      {"\u0394", "^"},     {"\u03B4", "^"},     {"\u2206", "^"},
    {"\u25B3", "^"},   {"\u00B0", " deg "}, {"\u00BA", " deg "}, {"\u02DA", " deg "},
    {"cm/m", " ^ "},   {"\u00DF", "ss"},    {"\u2322", " / "},  // "combined with"
    {"\u00B7", "."},   {"\u00BC", ".25"},   {"\u00BD", ".50"},   {"\u00BE", ".75"},
}};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return c >= 'a' && c <= 'z';
}

/// "2 ½" is 2½.
void join_fractions(std::string& text) {
  for (const std::string_view fraction : {"\u00BC"sv, "\u00BD"sv, "\u00BE"sv})
    for (std::size_t at = 0; (at = text.find(fraction, at)) != std::string::npos; at += fraction.size()) {
      std::size_t digits = at;
      while (digits > 0 && text[digits - 1] == ' ') --digits;
      if (digits == 0 || !is_digit(text[digits - 1])) continue;
      text.erase(digits, at - digits);
      at = digits;
    }
}

std::string in_ascii(std::string_view text) {
  std::string plain = with_keyboard_signs(text);
  join_fractions(plain);
  for (const auto& [typed, spelt] : spellings)
    for (std::size_t at = 0; (at = plain.find(typed, at)) != std::string::npos; at += spelt.size())
      plain.replace(at, typed.size(), spelt);
  return lower_case(plain);
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(in_ascii(text)) {}

  std::vector<NotationToken> run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (is_digit(c) || (c == '.' && is_digit(peek(1))) || ((c == '+' || c == '-') && number_follows()))
        number();
      else if (is_letter(c))
        word();
      else if (c == '^' || c == '@')
        add_word(text_.substr(at_++, 1));
      else if (c == '-' && at_ > 0 && (is_digit(text_[at_ - 1]) || text_[at_ - 1] == '.'))
        throw NotationError("a sign before its number, not behind it");
      else if (" \t\r\n/,;:()[]=|.&-_"sv.find(c) != std::string_view::npos)
        ++at_;
      else
        fail_at_character();
    }
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  /// Whether the sign here belongs to a number; blanks may stand between them.
  bool number_follows() const {
    const std::size_t next = text_.find_first_not_of(" \t", at_ + 1);
    if (next == std::string::npos) return false;
    if (text_[next] == '+' || text_[next] == '-')
      throw NotationError("one sign before a number, not \"" + text_.substr(at_, next + 1 - at_) + "\"");
    const bool point = text_[next] == '.' || text_[next] == ',';
    return is_digit(text_[next]) || (point && next + 1 < text_.size() && is_digit(text_[next + 1]));
  }

  void number() {
    NotationToken token;
    token.is_number = true;
    if (text_[at_] == '+' || text_[at_] == '-') {
      token.has_sign = true;
      token.text = text_[at_];
      at_ = text_.find_first_not_of(" \t", at_ + 1);
    }
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      const bool point = (c == '.' || c == ',') && !token.has_point && is_digit(peek(1));
      if (!point && !is_digit(c)) break;
      token.has_point |= point;
      token.text += point ? '.' : c;
    }
    if (is_fraction(token))
      throw NotationError("a decimal number in place of \"" + token.text + text_.substr(at_, 2) +
                          "\", which may be a fraction, or a cylinder and its axis");
    const std::size_t start = token.text.starts_with('+') ? 1 : 0;
    const char* end = token.text.data() + token.text.size();
    if (read_number(token.text.data() + start, end, token.value) != end)
      throw NotationError("a number in place of \"" + token.text + "\"");
    tokens_.push_back(std::move(token));
  }

  /// Whether "1/4", "3/4" or the like begins with this number, which ends at the slash.
  bool is_fraction(const NotationToken& number) const {
    const char top = number.text.back(), bottom = peek(1);
    const bool one_digit = number.text.size() == (number.has_sign ? 2 : 1);
    return one_digit && peek(0) == '/' && !is_digit(peek(2)) && peek(2) != '.' && peek(2) != ',' &&
           ((bottom == '2' && top == '1') || ((bottom == '4' || bottom == '8') && "1357"sv.find(top) < 4));
  }

  /// Letters; points within abbreviations ("o.d.") do not end it.
  void word() {
    std::string letters;
    while (at_ < text_.size() && (is_letter(text_[at_]) || (text_[at_] == '.' && is_letter(peek(1)))))
      if (const char c = text_[at_++]; c != '.') letters += c;
    if (peek(0) == '.' && is_digit(peek(1)))
      throw NotationError("a blank behind \"" + letters + "\", since the point may be its own or the number's");
    for (const char* unit : {"dc", "ds", "d", "cyl", "sph"})  // "-1.50DCx30"
      if (letters == std::string(unit) + "x") {
        add_word(unit);
        letters = "x";
      }
    add_word(letters);
  }

  void add_word(const std::string& letters) {
    NotationToken token;
    token.text = letters;
    if (is_plano(letters)) {
      token.is_number = token.has_sign = token.has_point = true;
    } else {
      const auto* known =
          std::find_if(std::begin(words), std::end(words), [&](const Word& word) { return word.text == letters; });
      if (known == std::end(words)) fail_at_word(letters);
      token.term = known->term;
    }
    tokens_.push_back(std::move(token));
  }

  [[noreturn]] static void fail_at_word(const std::string& letters) {
    std::vector<std::string> known;
    for (const Word& word : words) known.emplace_back(word.text);
    for (const std::string_view plano : planos) known.emplace_back(plano);
    const std::string nearest = letters.size() > 2 ? did_you_mean(letters, known) : "";
    throw NotationError("a prescription such as \"-2.00 -1.50 x 30\", without the word \"" + readable(letters, 40) +
                        "\"" + nearest);
  }

  [[noreturn]] void fail_at_character() const {
    std::size_t size = 1;
    while ((static_cast<unsigned char>(peek(size)) & 0xC0) == 0x80) ++size;
    throw NotationError("a prescription such as \"-2.00 -1.50 x 30\", without \"" + text_.substr(at_, size) + "\"");
  }

  std::string text_;
  std::size_t at_ = 0;
  std::vector<NotationToken> tokens_;
};

}  // namespace

std::vector<NotationToken> notation_tokens(std::string_view text) {
  if (text.size() > longest_text)
    throw NotationError("a prescription of at most " + std::to_string(longest_text) + " bytes");
  return Scanner(utf8_text(std::string(text))).run();
}

bool is_plano(std::string_view word) {
  return std::find(planos.begin(), planos.end(), word) != planos.end();
}

bool may_lack_its_point(std::string_view number) {
  if (number.starts_with('+') || number.starts_with('-')) number.remove_prefix(1);
  if (number.size() < 2 || !std::all_of(number.begin(), number.end(), is_digit)) return false;
  if (number.front() == '0') return true;
  const std::string_view end = number.substr(number.size() - 2);
  return end == "00" || end == "25" || end == "50" || end == "75";
}

}  // namespace sturm
