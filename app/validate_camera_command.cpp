#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/gate_lines.h"
#include "app/plotted.h"
#include "compare/gates/verdict.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/images/picture_file.h"
#include "io/json/json_text.h"
#include "reports/text/junit.h"
#include "reports/text/markdown.h"
#include "stages/camera_check.h"
#include "stages/camera_check_scene.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

constexpr double focus_m = 1.0, camera_pupil_mm = 6.0;

/// The eye that the scene is made for: that of the option, else one that is in focus at 1 m, as a thin lens is.
PlottedEye camera_of(const ValidateCameraOptions& options) {
  PlotOptions eye;
  eye.kind = "--eye";
  eye.prescription = options.prescription.empty() ? "0.00" : options.prescription;
  eye.worn.pupil_mm = options.pupil_mm.value_or(camera_pupil_mm);
  if (!options.eye.empty()) {
    eye.files = {options.eye};
    eye.prescription = options.prescription;
    eye.worn.pupil_mm = options.pupil_mm;
  } else {
    eye.worn.focus_m = exact_number(options.focus_m.value_or(focus_m));
  }
  return plotted_eyes(eye).front();
}

int write_check(const ValidateCameraOptions& options) {
  const PlottedEye camera = camera_of(options);
  if (camera.worn.spectacles) throw InputError(camera.file, "", "an eye behind spectacles", "a naked eye");
  CameraCheck check;
  try {
    check = camera_check(camera.worn.eye);
  } catch (const std::invalid_argument& error) {
    throw InputError(camera.file, "", error.what(), "an eye with a pupil and a fixed accommodation");
  }
  fs::create_directories(options.folder);
  for (const auto& [name, contents] : camera_check_files(check, camera.worn.eye, camera.eye))
    write_file_atomically(fs::path(options.folder) / name, contents);
  write_file_atomically(fs::path(options.folder) / "expected.json", json_text(to_json(check, camera.eye), 1) + "\n");
  std::cout << options.folder << ": " << check.lamps.size()
            << " lamps. Render scene.gltf or scene.obj with the camera of "
            << "camera.json into picture.exr there, then run sturm validate-camera " << options.folder << "\n";
  return 0;
}

/// One demand on one lamp.
class Demands {
 public:
  Demands(const ValidateCameraOptions& options, const CameraCheck& check) : options_(options), check_(check) {}

  void judge(const CheckedLamp& lamp, const std::optional<MeasuredLamp>& measured) {
    lamp_ = lamp.id;
    // As it stands in the picture, so that a spot in focus has a size, too.
    const Eigen::Matrix2d own = (check_.lamp_variance_px(lamp) + pixel_variance) * Eigen::Matrix2d::Identity();
    const Ellipse expected = Ellipse::of_second_moments(lamp.covariance_px + own);
    std::optional<double> shift, axes, turn;
    if (measured) {
      shift = (measured->centroid_px - lamp.centroid_px).norm();
      const Ellipse seen = Ellipse::of_second_moments(measured->covariance_px + own);
      axes = std::max(std::abs(seen.semi_major - expected.semi_major), std::abs(seen.semi_minor - expected.semi_minor));
      if (seen.orientation_deg && expected.orientation_deg)
        turn = std::abs(std::remainder(*seen.orientation_deg - *expected.orientation_deg, 180.0));
    }
    add("centroid", "shift of the centroid", shift, options_.centroid_px, "px");
    add("semi_axes", "larger error of the semi-axes", axes,
        options_.relative * expected.semi_major + options_.absolute_px, "px");
    if (expected.semi_major - expected.semi_minor > least_elongation * expected.semi_major)
      add("orientation", "turn of the long axis", turn, options_.orientation_deg, "deg");
  }

  const std::vector<GateResult>& results() const { return results_; }

 private:
  /// Below it the direction of an axis says little.
  static constexpr double least_elongation = 0.2;
  static constexpr double pixel_variance = 1.0 / 12.0;

  void add(const std::string& what, const std::string& title, const std::optional<double>& value, double bound,
           const std::string& unit) {
    GateResult result;
    result.id = lamp_ + "/" + what;
    result.title = lamp_ + ": " + title;
    result.statistic = what;
    result.kind = GateKind::AtMost;
    result.value = value;
    result.bound = bound;
    result.unit = unit;
    result.passed = value && *value <= bound;
    result.worst_case = value ? lamp_ : "no light where its spot should be";
    result.reason = "tolerance of the camera check (docs/commands/validate-camera.md)";
    results_.push_back(result);
  }

  const ValidateCameraOptions& options_;
  const CameraCheck& check_;
  std::string lamp_;
  std::vector<GateResult> results_;
};

}  // namespace

int validate_camera_command(const ValidateCameraOptions& options) {
  if (options.write) return write_check(options);
  const std::string expected = (fs::path(options.folder) / "expected.json").string();
  if (std::error_code code; !fs::exists(expected, code))
    throw InputError(expected, "", "No such file",
                     "a folder that \"sturm validate-camera " + options.folder + " --write\" has written");
  const CameraCheck check = read_camera_check(load_json(expected), expected);
  const std::string file =
      options.picture.empty() ? (fs::path(options.folder) / "picture.exr").string() : options.picture;
  const PictureFile picture = read_picture_file(file);
  if (picture.values == PixelValues::Display)
    throw InputError(file, "", "a picture for a display", "linear light: EXR, HDR or PFM");
  const Image image = picture.image().channels > 3 ? without_alpha(picture.image()) : picture.image();
  require_light(image, file);
  const auto measured = measure_lamps(image, check, file);
  Demands demands(options, check);
  for (std::size_t i = 0; i < check.lamps.size(); ++i) demands.judge(check.lamps[i], measured[i]);
  const Verdict verdict = verdict_of(demands.results());
  std::cout << gate_lines(demands.results()) << verdict.sentence << "\n";
  if (!options.junit.empty()) write_file_atomically(options.junit, junit_xml(demands.results(), "camera"));
  if (!options.markdown.empty())
    write_file_atomically(options.markdown, gates_markdown("Camera check of " + file, demands.results(), verdict));
  return verdict.has_passed() ? 0 : 1;
}

}  // namespace sturm
