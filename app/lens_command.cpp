#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/lens_stage.h"
#include "io/error.h"
#include "io/schema.h"
#include "io/spectacles_spec.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double largest_angle_deg = 89.0;
constexpr double most_angles = 721.0;

/// FIRST:LAST:STEP or one angle.
std::vector<double> angles(const std::string& text, const char* option) {
  const auto refuse = [&] {
    throw InputError("", option, "\"" + text + "\"",
                     "FIRST:LAST:STEP with -89 <= FIRST <= LAST <= 89, STEP > 0 and at most 721 angles, or one angle [deg]");
  };
  std::vector<double> numbers;
  const char *at = text.data(), *end = at + text.size();
  for (double number = 0.0;; ++at) {
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc()) refuse();
    numbers.push_back(number);
    at = stop;
    if (at == end) break;
    if (*at != ':') refuse();
  }
  if (numbers.size() == 1) numbers = {numbers[0], numbers[0], 1.0};
  if (numbers.size() != 3) refuse();
  const double first = numbers[0], last = numbers[1], step = numbers[2];
  if (!(first >= -largest_angle_deg && first <= last && last <= largest_angle_deg && step > 0.0)) refuse();
  const double steps = std::floor((last - first) / step * (1.0 + 1e-12));  // 0:1:0.1 reaches 1
  if (!(steps < most_angles)) refuse();
  std::vector<double> result;
  for (int i = 0; i <= static_cast<int>(steps); ++i) result.push_back(std::fmin(first + i * step, last));
  return result;
}

Spectacles read_lens(const Json& document, const std::string& file) {
  if (format_of(document, file) != "spectacles") Source{file, "/format"}.fail(document.at("format"), "\"sturm.spectacles/1\"");
  validate(document, "spectacles", file);
  if (const auto made = document.find("single_vision"); made != document.end() && !made->contains("prescription"))
    throw InputError(file, "/single_vision", "no \"prescription\"", "\"prescription\": there is no eye here to take it from");
  return read_spectacles(document, {file, ""}, Eye{}).lens.value();
}

}  // namespace

int lens_command(const CommonOptions& options, const LensOptions& lens, const std::string& output) {
  LensQuery query;
  query.azimuths_deg = angles(lens.azimuths_deg, "--azimuth-deg");
  query.elevations_deg = angles(lens.elevations_deg, "--elevation-deg");
  query.rotation_center_m = metres_per_millimetre * lens.rotation_center_mm;
  query.lens = read_lens(load_configuration(options), options.file);
  write_result(lens_report(query), output);
  return 0;
}

}  // namespace sturm
