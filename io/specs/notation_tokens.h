#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sturm {

/// A text in optical notation cannot be read; what() says what was expected instead.
class NotationError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// What a word of the notation means, whatever language or abbreviation it is in.
enum class Term {
  right_eye,
  left_eye,
  both_eyes,
  sphere,          ///< before or behind its number: "sph -2.00", "-2.00 sph"
  cylinder,        ///< the same
  spheres_unit,    ///< behind its number: "DS"
  cylinders_unit,  ///< behind its number: "DC"
  dioptres,        ///< behind a number; says nothing
  axis,            ///< before its number: "x", "ax"
  meridian,        ///< "@"
  degrees,         ///< behind an angle
  addition,
  vertex_distance,
  millimetres,
  prism,  ///< before or behind its number: "prism", "^"
  base,   ///< before a direction
  base_in,
  base_out,
  base_up,
  base_down,
  filler,  ///< "Rx", "eye", "and": says nothing
};

/// A number or a word of a text.
struct NotationToken {
  std::string text;  ///< as it is understood: in lower case, with ASCII signs
  bool is_number = false;
  double value = 0.0;
  bool has_sign = false, has_point = false;
  Term term = Term::filler;  ///< of a word
};

/// Cuts a text into numbers and words; "plano" is the number 0. Slashes, commas, colons and brackets only separate.
/// Throws NotationError for a word or a character that is not of the notation.
std::vector<NotationToken> notation_tokens(std::string_view text);

/// Whether a word in lower case stands for no power at all: "pl", "plano".
bool is_plano(std::string_view word);

/// Whether a power is written in whole numbers that may be hundredths: "-200" stands for -2.00 to some, "-075" for
/// -0.75, and in a table "25" or "00" may be what stood behind a decimal comma. `number`: a sign or none, digits, and
/// what else a number has.
bool may_lack_its_point(std::string_view number);

}  // namespace sturm
