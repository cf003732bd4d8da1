#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/distance_option.h"
#include "app/see_inputs.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/images/exr.h"
#include "io/json/json_text.h"
#include "io/json/manifest.h"
#include "io/json/schema.h"
#include "io/specs/eye_spec.h"
#include "stages/image_files.h"
#include "stages/see_stage.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

constexpr int default_parts = 4;

/// A frame of a sequence, or the only picture.
struct Frame {
  std::optional<double> focus_D, pupil_mm;  // in place of the options'
  fs::path file;
};

std::vector<Frame> frames_of(const SeeOptions& options) {
  const fs::path file(options.output);
  if (options.rack_focus_D.empty() && options.pupil_sequence_mm.empty()) return {{std::nullopt, std::nullopt, file}};
  std::vector<Frame> frames;
  for (int i = 0; i < options.frames; ++i) {
    const auto between = [&](const std::vector<double>& ends) {
      return ends.empty() ? std::nullopt
                          : std::optional(std::lerp(ends[0], ends[1], static_cast<double>(i) / (options.frames - 1)));
    };
    char number[16];
    std::snprintf(number, sizeof number, "_%04d", i + 1);
    frames.push_back({between(options.rack_focus_D), between(options.pupil_sequence_mm),
                      file.parent_path() / (file.stem().string() + number + file.extension().string())});
  }
  return frames;
}

/// The eye's document with what options and frame put in place of its own.
Json eye_document(const SeeOptions& options, const Frame& frame, const Json& written) {
  Json eye = written;
  if (options.pupil_mm) eye["pupil_diameter_mm"] = *options.pupil_mm;
  if (frame.pupil_mm) eye["pupil_diameter_mm"] = *frame.pupil_mm;
  if (options.focus_D) eye["accommodation"] = {{"mode", "fixed"}, {"power_D", *options.focus_D}};
  if (frame.focus_D) eye["accommodation"] = {{"mode", "fixed"}, {"power_D", *frame.focus_D}};
  if (!options.focus_m.empty()) {
    const double distance_m = distance_option(options.focus_m, "--focus-m");
    eye["accommodation"] = {{"mode", "fixed"},
                            {"focus_distance_m", std::isinf(distance_m) ? Json("inf") : Json(distance_m)}};
  }
  validate(eye, "eye", options.eye);
  return eye;
}

/// An eye that accommodates as well as it can needs one distance to do so for.
double accommodation_of(const Eye& eye, const SeeOptions& options, const SeeInputs& inputs) {
  if (options.distance_m.empty())
    require_camera_accommodation(eye.accommodation, std::nullopt, {options.eye, "/accommodation"});
  return eye.accommodation_for(inputs.picture.vergence_D.front());
}

void write_seen(const fs::path& file, const Image& radiance, double exposure, const Json& spec) {
  if (file.extension() == ".exr")
    write_exr(file, LayeredImage{{{"", radiance}}, {{"sturm.see", json_text(spec)}}});
  else
    write_png(file, radiance, exposure);
}

/// The options with every default spelt out.
Json spec_of(const SeeOptions& options, const SeeInputs& inputs, const Json& eye, int parts) {
  Json spec = {{"format", "sturm.see/1"},
               {"picture", options.picture},
               {"layers", options.layers},
               {"eye", with_defaults(eye, "eye")},
               {"pixel_slope", inputs.pixel_slope},
               {"psf", options.psf},
               {"parts", parts},
               {"chromatic", options.chromatic},
               {"exposure", options.exposure}};
  const std::string map = options.disparity_file.empty() ? options.depth : options.disparity_file;
  if (!options.distance_m.empty())
    spec["distance_m"] = options.distance_m;
  else
    spec["depth"] = {{"file", map.empty() ? options.picture : map},
                     {"unit", options.disparity ? "disparity" : options.depth_unit},
                     {"scale", options.depth_scale.value_or(1.0)}};
  if (options.disparity)
    spec["stereo"] = {
        {"focal_px", *options.focal_px}, {"baseline_m", *options.baseline_m}, {"doffs_px", options.doffs_px}};
  return spec;
}

class SeeRun {
 public:
  SeeRun(const CommonOptions& common, const SeeOptions& options)
      : options_(options), inputs_(read_see_inputs(options)), eye_(eye_object(Json(options.eye), {})) {
    facts_.threads = thread_count(common);
    facts_.started_utc = utc_now();
    facts_.input_files = inputs_.files;
    facts_.input_files.push_back(options.eye);
    parts_ = options.parts.value_or(options.error ? parts_for_error(*options.error) : default_parts);
    for (const Frame& frame : frames_of(options)) frames_.emplace_back(frame, settings_of(frame));
  }

  void explain() { std::cout << explanation_of(see(frames_.front().second)); }

  void write() {
    for (const auto& [frame, settings] : frames_) require_writable(frame.file);
    const Json spec = spec_of(options_, inputs_, eye_document(options_, frames_.front().first, eye_), parts_);
    Json counters = {{"filled_holes", inputs_.filled_holes}, {"frames", Json::array()}};
    for (const auto& [frame, settings] : frames_) {
      const SeenPicture seen = see(settings);
      Stopwatch writing;
      write_seen(frame.file, seen.radiance, options_.exposure, spec);
      facts_.seconds["writing"] += writing.seconds();
      Json entry = counters_of(seen);
      entry["file"] = frame.file.filename().string();
      entry["accommodation_D"] = settings.accommodation_D;
      entry["pupil_diameter_mm"] = 2e3 * settings.eye.pupil_radius_m;
      counters["frames"].push_back(std::move(entry));
    }
    facts_.seconds["total"] = total_.seconds();
    fs::path beside(options_.output);
    write_file_atomically(beside.replace_extension(".manifest.json"),
                          json_text(manifest(facts_, spec, counters, inputs_.notes), 1) + "\n");
  }

 private:
  SeeSettings settings_of(const Frame& frame) {
    const EyeSpec spec = read_eye_spec(eye_document(options_, frame, eye_), {options_.eye, ""});
    if (frames_.empty()) inputs_.notes.insert(inputs_.notes.end(), spec.notes.begin(), spec.notes.end());
    SeeSettings settings;
    settings.eye = spec.eye;
    settings.accommodation_D = accommodation_of(spec.eye, options_, inputs_);
    settings.pixel_slope = inputs_.pixel_slope;
    settings.psf = *seen_psf_words.value_of(options_.psf);
    settings.chromatic = options_.chromatic;
    settings.parts = parts_;
    return settings;
  }

  SeenPicture see(const SeeSettings& settings) {
    SeenPicture seen = see_picture(inputs_.picture, inputs_.layers, settings);
    for (const auto& [part, seconds] : seen.seconds) facts_.seconds[part] += seconds;
    return seen;
  }

  const SeeOptions& options_;
  Stopwatch total_;
  SeeInputs inputs_;
  Json eye_;
  RunFacts facts_;
  int parts_ = default_parts;
  std::vector<std::pair<Frame, SeeSettings>> frames_;
};

}  // namespace

int see_command(const CommonOptions& common, const SeeOptions& options) {
  if (!options.disparity_file.empty() && !options.depth.empty())
    throw InputError("", "--disparity", "\"" + options.disparity_file + "\"", "one depth map, beside --depth no other");
  const std::string suffix = fs::path(options.output).extension().string();
  if (!options.explain && suffix != ".png" && suffix != ".exr")
    throw InputError("", "--output", "\"" + options.output + "\"", "a name that ends in .png or .exr");
  SeeRun run(common, options);
  if (options.explain)
    run.explain();
  else
    run.write();
  return 0;
}

}  // namespace sturm
