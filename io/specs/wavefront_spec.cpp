#include "io/specs/wavefront_spec.h"

#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/eye_spec.h"
#include "io/specs/words.h"
#include "lensmodel/units.h"
#include "lensmodel/zernike_order.h"

namespace sturm {

namespace {

/// Coefficients [m] from the first number of their order on, as given.
std::vector<double> read_coefficients(const Json& value, const Source& where, ZernikeOrder order) {
  const int first = first_number(order), last = last_number(order);
  const std::string expected = "a number of order \"" + std::string(zernike_order_words.word_of(order)) + "\", from " +
                               std::to_string(first) + " to " + std::to_string(last);
  std::vector<double> c;
  if (value.is_array()) {
    if (value.size() > static_cast<std::size_t>(last - first + 1))
      where.fail(value,
                 "at most " + std::to_string(last - first + 1) + " coefficients, the last of them for " + expected);
    for (const Json& coefficient : value) c.push_back(metres_per_micrometre * coefficient.get<double>());
    return c;
  }
  for (const auto& [key, coefficient] : value.items()) {
    const int number = std::stoi(key);
    if (number < first || number > last) (where / key).fail(coefficient, expected);
    const auto place = static_cast<std::size_t>(number - first);
    c.resize(std::max(c.size(), place + 1), 0.0);
    c[place] = metres_per_micrometre * coefficient.get<double>();
  }
  return c;
}

/// Whether the document asks for the wavefront of the other eye, as it would be by mirror symmetry.
bool wants_mirror(const Json& value, const Source& where) {
  if (!value.contains("mirror_to")) return false;
  if (!value.contains("eye"))
    throw InputError(where.file, where.pointer, "\"mirror_to\" without \"eye\"",
                     "\"eye\": which eye the coefficients belong to");
  return value["mirror_to"] != value["eye"];
}

}  // namespace

WavefrontSpec read_wavefront(const Json& value, const Source& where) {
  const ZernikeOrder order = read_word(value["order"], where / "order", zernike_order_words);
  const bool normalised = value.value("normalised", usually_normalised(order));
  std::vector<double> osa = osa_coefficients(
      read_coefficients(value["coefficients_um"], where / "coefficients_um", order), order, normalised);
  if (wants_mirror(value, where)) osa = mirrored(osa);
  WavefrontSpec spec{
      ZernikeWave::from_examiner(osa, 0.5 * metres_per_millimetre * value["pupil_diameter_mm"].get<double>()),
      read_word(value["second_order"], where / "second_order", second_order_words),
      value["combine"].get<bool>(),
      {}};
  if (value.contains("wavelength_nm")) spec.wavelength_nm = value["wavelength_nm"].get<double>();
  return spec;
}

std::optional<double> stated_wavelength_nm(const Json& eye, const Source& where) {
  const Json object = eye_object(eye, where);
  const auto wavefront = object.find("wavefront");
  if (wavefront == object.end() || !wavefront->contains("wavelength_nm")) return std::nullopt;
  return (*wavefront)["wavelength_nm"].get<double>();
}

}  // namespace sturm
