#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/text_answers.h"
#include "io/files/atomic_file.h"
#include "io/files/csv.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/json/json_text.h"
#include "io/json/schema.h"
#include "io/specs/eye_spec.h"
#include "io/specs/wavefront_spec.h"
#include "lensmodel/units.h"
#include "lensmodel/zernike_order.h"
#include "stages/wavefront_stage.h"
#include "wavefront/fitting/virtual_eyes.h"

namespace sturm {

namespace {

/// A wavefront from whatever source, and what is said of it.
struct Outcome {
  WavefrontEye eye;
  Json report;            ///< of a fit; else what is said besides the eye itself
  std::string residuals;  ///< CSV, "" where there is no fit
};

/// Throws unless an option that is a length (or the like) is a number > 0 and not absurd.
void require_positive(const std::optional<double>& value, const char* option, double largest) {
  if (value && !(*value > 0.0 && *value <= largest))
    throw InputError("", option, plain_number(*value), "a number > 0, up to " + plain_number(largest));
}

double required(const std::optional<double>& value, const char* option, const char* what) {
  if (!value) throw InputError("", option, "nothing", what);
  return *value;
}

std::optional<int> read_order(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const std::optional<double> number = csv_number(text);
  if (!number || *number != std::floor(*number) || *number < 1 || *number > 20)
    throw InputError("", "--order", "\"" + text + "\"", "a radial order from 1 to 20, or auto");
  return static_cast<int>(*number);
}

double lenslet_of(const WavefrontOptions& o, bool heights) {
  if (heights || o.gradient == "center") return 0.0;
  return metres_per_millimetre *
         required(o.lenslet_mm, "--lenslet-mm", "the side of a lenslet [mm], or --gradient center");
}

SensorTableOptions table_options(const WavefrontOptions& o) {
  SensorTableOptions table;
  if (o.pixel_um) table.pixel_m = metres_per_micrometre * *o.pixel_um;
  if (o.focal_length_mm) table.focal_length_m = metres_per_millimetre * *o.focal_length_mm;
  if (o.grid_step_mm) table.grid_step_m = metres_per_millimetre * *o.grid_step_mm;
  table.wavelength_nm = o.wavelength_nm;
  if (!o.center.empty()) table.centre = Eigen::Vector2d(o.center[0], o.center[1]);
  table.frame = table_frame_words.value_of(o.frame);
  table.negative_slopes = o.negative_slopes;
  return table;
}

std::string residual_table(const WavefrontQuery& query, const FittedWavefront& fitted) {
  CsvWriter csv;
  const bool heights = query.table.heights;
  for (const char* name : {"line", "x_mm", "y_mm"}) csv.text(name);
  if (heights)
    csv.text("residual_um");
  else
    for (const char* name : {"residual_x_rad", "residual_y_rad"}) csv.text(name);
  csv.text("used");
  csv.end_row();
  for (std::size_t i = 0; i < fitted.points.size(); ++i) {
    const SensorPoint& point = fitted.points[i];
    const auto row = static_cast<Eigen::Index>(i);
    csv.number(point.line);
    csv.number(point.point.x() / metres_per_millimetre);
    csv.number(point.point.y() / metres_per_millimetre);
    if (heights)
      csv.number(fitted.fit.residuals[row] / metres_per_micrometre);
    else
      for (int k = 0; k < 2; ++k) csv.number(fitted.fit.residuals[2 * row + k]);
    csv.number(fitted.fit.used[i] ? 1 : 0);
    csv.end_row();
  }
  return csv.table();
}

Outcome fit_table(const WavefrontOptions& o) {
  WavefrontQuery query;
  query.file = o.file;
  const double pupil_mm = required(o.pupil_mm, "--pupil-mm", "the diameter of the measured pupil [mm]");
  query.pupil_radius_m = 0.5 * metres_per_millimetre * pupil_mm;
  query.radial_order = read_order(o.order);
  query.table = read_sensor_table(o.file, table_options(o));
  query.lenslet_m = lenslet_of(o, query.table.heights);
  query.keep_spurious = o.keep_spurious;
  query.drop_outside = o.drop_outside;
  if (o.noise) query.noise = *o.noise * (query.table.heights ? metres_per_micrometre : 1.0);
  const FittedWavefront fitted = fit_wavefront(query);
  Outcome outcome;
  outcome.eye.coefficients_um = fitted.coefficients_um();
  outcome.eye.measured_pupil_mm = outcome.eye.pupil_mm = pupil_mm;
  outcome.eye.wavelength_nm = o.wavelength_nm;
  outcome.eye.source =
      formatted("fitted to %zu measurements up to radial order %d", fitted.points.size(), fitted.radial_order);
  outcome.report = wavefront_report(query, fitted, o.mirror);
  outcome.residuals = residual_table(query, fitted);
  return outcome;
}

/// Of an eye that is written without a fit; `about` says what it was.
Json plain_report(Json about, const WavefrontEye& eye) {
  Json list = Json::array();
  for (std::size_t j = 0; j < eye.coefficients_um.size(); ++j) {
    const ZernikeIndex index = ZernikeIndex::of(static_cast<int>(j));
    list.push_back({{"j", j}, {"n", index.n}, {"m", index.m}, {"value_um", eye.coefficients_um[j]}});
  }
  about["format"] = "sturm.wavefront_report/1";
  about["pupil_diameter_mm"] = eye.measured_pupil_mm;
  about["coefficients"] = std::move(list);
  about["refraction"] = refraction_json(eye.coefficients_um, eye.measured_pupil_mm);
  return about;
}

/// Coefficients [µm] in the examiner's frame over a smaller pupil.
std::vector<double> micrometres_over(const ZernikeWave& wearer, double pupil_mm) {
  std::vector<double> c = mirrored(wearer.rescaled(0.5 * metres_per_millimetre * pupil_mm).coefficients());
  for (double& value : c) value /= metres_per_micrometre;
  return c;
}

/// An eye's wavefront or prescription in OSA order, normalised.
Outcome restate_eye(const WavefrontOptions& o) {
  const Source where{o.file, ""};
  const Json document = load_json(o.file);
  if (format_of(document, o.file) != "eye") (where / "format").fail(document["format"], "\"sturm.eye/1\"");
  validate(document, "eye", o.file);
  const EyeSpec spec = read_eye_spec(document, where);
  const double own_mm = 2.0 * spec.eye.pupil_radius_m / metres_per_millimetre;
  const double measured_mm = spec.eye.wavefront ? 2.0 * spec.eye.wavefront->radius_m() / metres_per_millimetre : 0.0;
  const double pupil_mm = o.pupil_mm.value_or(spec.eye.wavefront ? measured_mm : own_mm);
  if (!(pupil_mm > 0.0)) throw InputError("", "--pupil-mm", "nothing", "the diameter of the pupil [mm]");
  if (spec.eye.wavefront && pupil_mm > measured_mm)
    throw InputError("", "--pupil-mm", plain_number(pupil_mm),
                     "at most the " + plain_number(measured_mm) + " mm that were measured");
  const ZernikeWave wave = spec.eye.wavefront
                               ? *spec.eye.wavefront
                               : ZernikeWave::of_power(spec.eye.correction, 0.5 * metres_per_millimetre * pupil_mm);
  Outcome outcome;
  WavefrontEye& eye = outcome.eye;
  eye.coefficients_um = micrometres_over(wave, std::min(pupil_mm, 2.0 * wave.radius_m() / metres_per_millimetre));
  eye.measured_pupil_mm = pupil_mm;
  eye.pupil_mm = own_mm > 0.0 ? std::min(own_mm, pupil_mm) : pupil_mm;
  eye.wavelength_nm = o.wavelength_nm ? o.wavelength_nm : stated_wavelength_nm(document, where);
  eye.source = document.value("source", "restated from an eye's document");
  for (const char* key : {"rotation_center_mm", "accommodation", "stiles_crawford_per_mm2"})
    if (document.contains(key)) eye.others[key] = document[key];
  if (document.contains("wavefront")) {
    const Json& measured = document["wavefront"];
    if (measured.contains("eye")) eye.side = measured.value("mirror_to", measured["eye"].get<std::string>());
    if (measured.contains("second_order")) eye.second_order = measured["second_order"].get<std::string>();
  }
  outcome.report["measured"] = "eye";
  return outcome;
}

Outcome random_eye(const WavefrontOptions& o) {
  const double pupil_mm = o.pupil_mm.value_or(6.0);
  const EyeStatistics* population = nullptr;
  for (const EyeStatistics& statistics : thibos_eyes())
    if (!population && statistics.pupil_diameter_mm >= pupil_mm) population = &statistics;
  if (!population)
    throw InputError("", "--pupil-mm", plain_number(pupil_mm),
                     "at most the 7.5 mm that the population was measured at");
  Eigen::VectorXd drawn = draw_eye(*population, o.seed);
  std::vector<double> c;
  for (const double um : drawn) c.push_back(metres_per_micrometre * um);
  const bool left = o.side == "left";  // the statistics are those of left eyes
  if (!left) c = mirrored(c);
  Outcome outcome;
  WavefrontEye& eye = outcome.eye;
  eye.coefficients_um = micrometres_over(
      ZernikeWave::from_examiner(c, 0.5 * metres_per_millimetre * population->pupil_diameter_mm), pupil_mm);
  eye.measured_pupil_mm = eye.pupil_mm = pupil_mm;
  eye.side = left ? "left" : "right";
  eye.wavelength_nm = o.wavelength_nm;
  eye.source = formatted("random eye %llu of the population of Thibos, Bradley and Hong (2002), %d eyes at %g mm",
                         static_cast<unsigned long long>(o.seed), population->eyes, population->pupil_diameter_mm);
  outcome.report = {{"measured", "random"}, {"seed", o.seed}};
  return outcome;
}

Outcome outcome_of(const WavefrontOptions& o) {
  if (o.random != o.file.empty())
    throw InputError("", "FILE", o.random ? "\"" + o.file + "\" and --random" : "nothing", "a file or --random");
  if (o.random) return random_eye(o);
  return o.file.ends_with(".json") ? restate_eye(o) : fit_table(o);
}

/// Throws where one result would replace another.
void require_files_of_their_own(const WavefrontOptions& o) {
  const auto name = [](const std::string& file) { return std::filesystem::absolute(file).lexically_normal(); };
  const std::pair<const char*, std::string> results[] = {
      {"--output", o.output}, {"--report", o.report}, {"--residuals", o.residuals}};
  for (const auto* one = std::begin(results); one != std::end(results); ++one)
    for (const auto* other = std::begin(results); other != one; ++other)
      if (!one->second.empty() && !other->second.empty() && name(one->second) == name(other->second))
        throw InputError("", one->first, "\"" + one->second + "\"",
                         std::string("a file of its own, beside that of ") + other->first);
}

/// What the options say of the eye's file whatever its source.
void finish(const WavefrontOptions& o, WavefrontEye& eye) {
  if (!o.side.empty()) eye.side = o.side;
  if (o.mirror) {
    eye.coefficients_um = mirrored(eye.coefficients_um);
    if (eye.side) eye.side = *eye.side == "left" ? "right" : "left";
  }
  if (o.no_tilt)
    for (std::size_t j = 0; j < 3 && j < eye.coefficients_um.size(); ++j) eye.coefficients_um[j] = 0.0;
  if (o.eye_pupil_mm) {
    if (*o.eye_pupil_mm > eye.measured_pupil_mm)
      throw InputError("", "--eye-pupil-mm", plain_number(*o.eye_pupil_mm),
                       "at most the " + plain_number(eye.measured_pupil_mm) + " mm that were measured");
    eye.pupil_mm = *o.eye_pupil_mm;
  }
}

}  // namespace

int wavefront_command(const WavefrontOptions& o) {
  constexpr double largest_mm = 100.0;
  for (const auto& [value, option] :
       {std::pair(o.pupil_mm, "--pupil-mm"), std::pair(o.eye_pupil_mm, "--eye-pupil-mm"),
        std::pair(o.lenslet_mm, "--lenslet-mm"), std::pair(o.grid_step_mm, "--grid-step-mm")})
    require_positive(value, option, largest_mm);
  require_positive(o.pixel_um, "--pixel-um", 1e4);
  require_positive(o.focal_length_mm, "--focal-length-mm", 1e4);
  require_positive(o.noise, "--noise", 1e3);
  if (o.wavelength_nm && !(*o.wavelength_nm >= 300.0 && *o.wavelength_nm <= 2000.0))
    throw InputError("", "--wavelength-nm", plain_number(*o.wavelength_nm), "a wavelength from 300 to 2000 nm");
  require_answer_name(o.output, AnswerKind::Json);
  require_answer_name(o.report, AnswerKind::Json, "--report");
  require_answer_name(o.residuals, AnswerKind::Csv, "--residuals");
  require_files_of_their_own(o);
  Outcome outcome = outcome_of(o);
  finish(o, outcome.eye);
  if (!o.residuals.empty() && outcome.residuals.empty())
    throw InputError("", "--residuals", "\"" + o.residuals + "\"", "a table of a sensor or of heights to fit");
  if (outcome.residuals.empty()) outcome.report = plain_report(outcome.report, outcome.eye);
  const Json eye = eye_document(outcome.eye);
  validate(eye, "eye", o.output);
  for (const std::string& file : {o.output, o.report, o.residuals})
    if (!file.empty()) require_writable(file);
  if (!o.output.empty()) write_file_atomically(o.output, json_text(eye, 1) + "\n");
  if (!o.residuals.empty()) write_file_atomically(o.residuals, outcome.residuals);
  write_result(outcome.report, o.report);
  return 0;
}

}  // namespace sturm
