#include "io/specs/notation_parser.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace sturm {

namespace {

// As in configs/schemas/eye.schema.json.
constexpr double largest_power_D = 40.0, largest_addition_D = 10.0, largest_prism = 40.0;
constexpr double largest_vertex_distance_mm = 50.0, largest_axis_deg = 180.0;

const char* const example = "\"-2.00 -1.50 x 30\"";

template <class Value>
void set_once(std::optional<Value>& place, Value value, const char* what) {
  if (place) throw NotationError(std::string("one ") + what + ", as in " + example);
  place = value;
}

}  // namespace

const NotationToken* NotationParser::peek(std::size_t ahead) const {
  return at_ + ahead < tokens_.size() ? &tokens_[at_ + ahead] : nullptr;
}

bool NotationParser::is(std::size_t ahead, Term term) const {
  const NotationToken* token = peek(ahead);
  return token && !token->is_number && token->term == term;
}

bool NotationParser::is_number(std::size_t ahead) const {
  const NotationToken* token = peek(ahead);
  return token && token->is_number;
}

bool NotationParser::skip(Term term) {
  return is(0, term) && ++at_ > 0;
}

void NotationParser::fail(const std::string& expected) const {
  const std::string read = read_so_far();
  throw NotationError(expected + (read.empty() ? "" : " (read so far: " + read + ")"));
}

std::string NotationParser::read_so_far() const {
  std::string text;
  const auto add = [&](const char* what, const std::optional<double>& value, const char* unit) {
    if (!value) return;
    NotedPrescription number;
    number.sphere_D = *value;
    std::string digits = in_notation(number);
    digits.erase(digits.rfind(' '));
    text += (text.empty() ? "" : ", ") + std::string(what) + " " + digits + unit;
  };
  add("sphere", section_.sphere_D, " D");
  add("cylinder", section_.cylinder_D, " D");
  if (section_.axis_deg) text += (text.empty() ? "axis " : ", axis ") + std::to_string(std::lround(*section_.axis_deg));
  add("addition", section_.addition_D, " D");
  return text;
}

std::vector<NotedPrescription> NotationParser::run() {
  if (tokens_.empty()) throw NotationError(std::string("a prescription such as ") + example);
  start_section(std::nullopt);
  while (at_ < tokens_.size()) tokens_[at_].is_number ? number() : word();
  finish_section();
  if (eyes_.size() > 2 || (eyes_.size() == 2 && (!eyes_[0].eye || !eyes_[1].eye || eyes_[0].eye == eyes_[1].eye)))
    throw NotationError("one prescription, or one for OD and one for OS");
  return eyes_;
}

void NotationParser::start_section(std::optional<EyeSide> eye) {
  section_ = {};
  section_.eye = eye;
  for (std::size_t i = 0; const NotationToken* token = peek(i); ++i) {
    if (token->is_number) break;
    if (token->term == Term::axis && is_number(i + 1)) ++i;  // "ax 30 sph -2.00"
    if (token->term == Term::sphere || token->term == Term::cylinder) section_.labels_come_first = true;
  }
}

void NotationParser::word() {
  const Term term = tokens_[at_++].term;
  switch (term) {
    case Term::right_eye:
    case Term::left_eye:
    case Term::both_eyes:
      if (section_.started || section_.eye || section_.both_eyes) finish_section();
      start_section(term == Term::both_eyes ? std::nullopt
                                            : std::optional(term == Term::right_eye ? EyeSide::right : EyeSide::left));
      section_.both_eyes = term == Term::both_eyes;
      return;
    case Term::sphere:
    case Term::cylinder:
      if (section_.labels_come_first) return labelled(term, expect_number("a number behind \"sph\" or \"cyl\""));
      fail("\"" + tokens_[at_ - 1].text + "\" directly behind its number");
    case Term::axis:
      return axis();
    case Term::addition:
      return addition(expect_number("an addition behind ADD, as in \"ADD +2.00\""));
    case Term::vertex_distance:
      return vertex_distance();
    case Term::meridian:
      if (is_number(0) && is(1, Term::millimetres)) return vertex_distance();
      fail("\"x\" before an axis: @ stands for the meridian of a power, too");
    case Term::prism:
      if (tokens_[at_ - 1].text == "pd" && is_number(0) && !is(1, Term::base) && !named_base(1))
        fail("a prescription without the distance of the pupils, \"PD " + tokens_[at_].text + "\"");
      return prism(expect_number("an amount of prism, as in \"2^ base up\""));
    case Term::base:
    case Term::base_in:
    case Term::base_out:
    case Term::base_up:
    case Term::base_down:
      return base_then_prism();
    case Term::filler:
      return;
    default:
      fail("a number before \"" + tokens_[at_ - 1].text + "\"");
  }
}

void NotationParser::number() {
  const NotationToken& token = tokens_[at_++];
  section_.started = true;
  const bool of_sphere = !section_.sphere_D && !section_.cylinder_D && whole_prism_follows();
  if (of_sphere && !token.has_sign && token.value != 0.0)
    fail("a sign before the sphere: \"" + token.text + "\" could be a sphere, or a prism with its base behind it");
  if (!of_sphere && prism_follows()) return prism(token);
  if (is(0, Term::addition) && !is_number(1)) return ++at_, addition(token);
  skip(Term::dioptres);
  if (skip(Term::spheres_unit)) return labelled(Term::sphere, token);
  if (skip(Term::cylinders_unit)) return labelled(Term::cylinder, token);
  if (!section_.labels_come_first && skip(Term::sphere)) return labelled(Term::sphere, token);
  if (!section_.labels_come_first && skip(Term::cylinder)) return labelled(Term::cylinder, token);
  const bool of_meridian = is(0, Term::meridian) && !(is_number(1) && is(2, Term::millimetres));
  return of_meridian ? meridian_behind(token) : unlabelled(token);
}

void NotationParser::labelled(Term term, const NotationToken& number) {
  section_.started = true;
  if (term == Term::sphere) {
    if (section_.cylinder_D && !section_.labels_come_first) fail("the sphere before the cylinder");
    set_once(section_.sphere_D, dioptres(number, "sphere", largest_power_D), "sphere");
    section_.sphere_is_labelled = true;
  } else {
    set_once(section_.cylinder_D, dioptres(number, "cylinder", largest_power_D), "cylinder");
  }
  while (skip(Term::dioptres) ||
         (section_.labels_come_first && (skip(Term::spheres_unit) || skip(Term::cylinders_unit)))) {
  }
}

void NotationParser::unlabelled(const NotationToken& number) {
  const bool may_be_axis = !number.has_sign && !number.has_point;
  if (!section_.sphere_D && !section_.cylinder_D) {
    if (is(0, Term::degrees))
      fail("the axis, " + number.text + "°, behind the cylinder, as in " + std::string(example));
    section_.sphere_D = dioptres(number, "sphere", largest_power_D);
    return;
  }
  if (section_.sphere_D && !section_.cylinder_D) {
    if (may_be_axis && (number.value > 10.0 || is(0, Term::degrees)))
      fail("a cylinder with a sign and a point before the axis: " + number.text + " could be an axis");
    section_.cylinder_D = dioptres(number, "cylinder", largest_power_D);
    return;
  }
  if (section_.cylinder_D && section_.sphere_D && !section_.axis_deg && !number.has_sign) {
    --at_;
    return axis();
  }
  fail("a sphere, a cylinder and an axis, then ADD, VD or prism with their names, not \"" + number.text + "\"");
}

void NotationParser::axis() {
  const std::optional<double> sphere = section_.sphere_D;
  const double degrees = angle("an axis from 0 to 180", largest_axis_deg);
  if (sphere && !section_.cylinder_D && !section_.sphere_is_labelled && *sphere != 0.0) {
    NotedPrescription alone;
    alone.sphere_D = *sphere;
    std::string power = in_notation(alone);
    power.erase(power.rfind(' '));
    const std::string at = " x " + tokens_[at_ - 1].text;
    fail("\"" + power + " DS\" if this is a sphere, \"PL " + power + at + "\" if it is a cylinder, or \"" + power +
         " -1.00" + at + "\" if a cylinder is missing");
  }
  set_once(section_.axis_deg, degrees, "axis");
  section_.started = true;
  skip(Term::degrees);
}

void NotationParser::meridian_behind(const NotationToken& number) {
  ++at_;
  const double degrees = angle("an angle from 0 to 180 behind @", largest_axis_deg);
  skip(Term::degrees);
  section_.meridians.push_back({dioptres(number, "power", largest_power_D), degrees});
}

void NotationParser::addition(const NotationToken& number) {
  section_.started = true;
  set_once(section_.addition_D, dioptres(number, "addition", largest_addition_D), "addition");
  skip(Term::dioptres);
}

void NotationParser::vertex_distance() {
  section_.started = true;
  while (skip(Term::vertex_distance) || skip(Term::filler)) {
  }
  const NotationToken& number = expect_number("a vertex distance [mm] behind VD, as in \"VD 12\"");
  if (number.has_sign || number.value > largest_vertex_distance_mm)
    fail("a vertex distance from 0 to 50 mm, not \"" + number.text + "\"");
  skip(Term::millimetres);
  set_once(section_.vertex_distance_mm, number.value, "vertex distance");
}

bool NotationParser::prism_follows() const {
  return is(0, Term::prism) || is(0, Term::base) || named_base(0);
}

std::optional<Term> NotationParser::named_base(std::size_t ahead) const {
  for (const Term term : {Term::base_in, Term::base_out, Term::base_up, Term::base_down})
    if (is(ahead, term)) return term;
  return std::nullopt;
}

/// A prism with an amount of its own: "prism 2 BI", or "BI 2" that is not the beginning of "BI 2^ BU".
bool NotationParser::whole_prism_follows() const {
  if (is(0, Term::prism) && is_number(1)) return is(2, Term::base) || named_base(2);
  const std::size_t base = is(0, Term::base) ? 1 : 0, behind = base + 2;
  return named_base(base) && is_number(base + 1) && !named_base(behind) && !is(behind, Term::base) &&
         !is(behind, Term::prism);
}

double NotationParser::prism_amount(const NotationToken& number) const {
  if ((number.has_sign && number.text[0] == '-') || number.value > largest_prism)
    fail("a prism from 0 to 40 dioptres with its base, not \"" + number.text + "\"");
  return number.value;
}

void NotationParser::add_prism(Term base, double amount) {
  NotedPrescription& p = section_.prism;
  (base == Term::base_in || base == Term::base_out ? p.prism_nasal : p.prism_up) +=
      base == Term::base_in || base == Term::base_up ? amount : -amount;
}

void NotationParser::base_then_prism() {
  section_.started = true;
  if (tokens_[at_ - 1].term != Term::base) --at_;
  const std::optional<Term> base = named_base(0);
  if (!base) fail("a number before \"" + tokens_[at_ - 1].text + "\", as in \"2^ base 135\"");
  ++at_;
  const double amount = prism_amount(expect_number("an amount of prism, as in \"base up 2\" or \"2^ base up\""));
  while (skip(Term::prism) || skip(Term::dioptres)) {
  }
  add_prism(*base, amount);
}

void NotationParser::prism(const NotationToken& number) {
  section_.started = true;
  const double amount = prism_amount(number);
  while (skip(Term::prism) || skip(Term::dioptres) || skip(Term::base)) {
  }
  if (const std::optional<Term> base = named_base(0)) return ++at_, add_prism(*base, amount);
  skip(Term::meridian);
  if (!is_number(0)) fail("where the base of the prism is: in, out, up, down or an angle, as in \"2^ base up\"");
  const double degrees = angle("a base from 0 to 360", 360.0), turn = degrees * std::numbers::pi / 180.0;
  skip(Term::degrees);
  section_.prism.prism_right += amount * (std::fmod(degrees, 180.0) == 90.0 ? 0.0 : std::cos(turn));
  section_.prism.prism_up += amount * (std::fmod(degrees, 180.0) == 0.0 ? 0.0 : std::sin(turn));
}

const NotationToken& NotationParser::expect_number(const char* what) {
  if (!is_number(0)) fail(what);
  return tokens_[at_++];
}

double NotationParser::angle(const char* what, double largest) {
  if (!is_number(0) || tokens_[at_].has_sign || tokens_[at_].value > largest)
    fail(std::string(what) + (peek() ? ", not \"" + peek()->text + "\"" : ""));
  return tokens_[at_++].value;
}

double NotationParser::dioptres(const NotationToken& number, const char* what, double largest) const {
  if (may_lack_its_point(number.text) || (!number.has_point && std::abs(number.value) > largest_power_D)) {
    NotedPrescription quarters;
    quarters.sphere_D = number.value / 100.0;
    std::string with_point = in_notation(quarters);
    with_point.erase(with_point.rfind(' '));
    fail(std::string("a point in the ") + what + ": \"" + number.text + "\" could be " + with_point + " D or " +
         number.text + " D (written " + with_point + " or " + number.text + ".00)");
  }
  if (std::abs(number.value) > largest)
    fail(std::string("a ") + what + " of at most " + std::to_string(std::lround(largest)) + " D either way, not \"" +
         number.text + "\"");
  return number.value + 0.0;  // "-0.00" is 0
}

void NotationParser::finish_cross() {
  Section& s = section_;
  if (s.meridians.size() == 2 && !s.sphere_D && !s.cylinder_D && !s.axis_deg &&
      std::abs(std::abs(s.meridians[0].angle_deg - s.meridians[1].angle_deg) - 90.0) < 1e-9) {
    // The power along the axis is the sphere.
    s.sphere_D = s.meridians[0].power_D;
    s.cylinder_D = s.meridians[1].power_D - s.meridians[0].power_D;
    s.axis_deg = s.meridians[0].angle_deg;
    return;
  }
  const Meridian& last = s.meridians.back();
  const long along = std::lround(last.angle_deg), across = (along + 90) % 180 == 0 ? 180 : (along + 90) % 180;
  fail(
      "\"x " + std::to_string(along) + "\" if @ stands for the axis of the cylinder, or \"x " + std::to_string(across) +
      "\" if it stands for the meridian of its power; two powers at right angles are read, as in \"-2.00 @ 180 / -3.50 "
      "@ 90\"");
}

void NotationParser::finish_section() {
  Section& s = section_;
  if (!s.meridians.empty()) finish_cross();
  if (!s.sphere_D && !s.cylinder_D && !s.prism.has_prism()) fail("a sphere, as in " + std::string(example));
  const double cylinder = s.cylinder_D.value_or(0.0);
  if (cylinder != 0.0 && !s.axis_deg) fail("an axis behind the cylinder, as in " + std::string(example));
  NotedPrescription rx = s.prism;
  rx.eye = s.eye;
  rx.sphere_D = s.sphere_D.value_or(0.0);
  rx.cylinder_D = cylinder;
  rx.axis_deg = s.axis_deg;
  rx.addition_D = s.addition_D;
  rx.vertex_distance_mm = s.vertex_distance_mm;
  if (s.both_eyes) {
    rx.eye = EyeSide::right;
    eyes_.push_back(rx);
    rx.eye = EyeSide::left;
  }
  eyes_.push_back(rx);
}

}  // namespace sturm
