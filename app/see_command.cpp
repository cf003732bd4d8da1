#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/eye_options.h"
#include "app/film.h"
#include "app/option_values.h"
#include "app/see_inputs.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/images/exr.h"
#include "io/json/json_text.h"
#include "io/json/manifest.h"
#include "io/json/named_file.h"
#include "io/json/schema.h"
#include "io/json/values.h"
#include "io/specs/eye_spec.h"
#include "stages/image_files.h"
#include "stages/see_stage.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

/// A frame of a sequence, or the only picture.
struct Frame {
  std::optional<double> focus_D, pupil_mm;  // in place of the options'
  fs::path file;
};

bool is_sequence(const SeeOptions& options) {
  return !options.rack_focus_D.empty() || !options.pupil_sequence_mm.empty();
}

std::vector<Frame> frames_of(const SeeOptions& options) {
  const fs::path file(options.output);
  if (!is_sequence(options)) return {{std::nullopt, std::nullopt, file}};
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

/// What the numbers of the depth map are taken for.
std::string depth_unit_of(const SeeOptions& options, const std::string& map) {
  if (options.disparity) return "disparity";
  if (!options.depth_unit.empty()) return options.depth_unit;
  return has_suffix(map, ".png") && !options.depth_scale ? "mm" : "m";
}

/// The eye's document with what options and frame put in place of its own.
Json eye_document(const SeeOptions& options, const Frame& frame, const Json& written) {
  Json eye = written;
  if (options.pupil_mm) eye["pupil_diameter_mm"] = *options.pupil_mm;
  if (frame.pupil_mm) eye["pupil_diameter_mm"] = *frame.pupil_mm;
  if (options.focus_D) eye["accommodation"] = {{"mode", "fixed"}, {"power_D", *options.focus_D}};
  if (frame.focus_D) eye["accommodation"] = {{"mode", "fixed"}, {"power_D", *frame.focus_D}};
  if (!options.focus_m.empty()) {
    const Json distance_m = distance_json(distance_option(options.focus_m, "--focus-m"));
    eye["accommodation"] = {{"mode", "fixed"}, {"focus_distance_m", distance_m}};
  }
  return eye;
}

/// An eye that accommodates as well as it can needs one distance to do so for.
double accommodation_of(const Eye& eye, const std::string& file, const SeeOptions& options, const SeeInputs& inputs) {
  if (options.distance_m.empty())
    require_camera_accommodation(eye.accommodation, std::nullopt, {file, "/accommodation"});
  return eye.accommodation_for(inputs.picture.vergence_D.front());
}

void write_seen(const fs::path& file, const Image& radiance, const SeeOptions& options, const Json& spec) {
  if (has_suffix(file, ".exr"))
    write_exr(file, LayeredImage{{{"", radiance}}, {{"sturm.see", json_text(spec)}}});
  else
    write_png(file, radiance, options.exposure, options.png_bits);
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
               {"exposure", options.exposure},
               {"png_bits", options.png_bits}};
  if (!options.picture_layer.empty()) spec["picture_layer"] = options.picture_layer;
  const std::string map = options.disparity_file.empty() ? options.depth : options.disparity_file;
  if (!options.distance_m.empty())
    spec["distance_m"] = distance_json(distance_option(options.distance_m, "--distance-m"));
  else
    spec["depth"] = {{"file", map.empty() ? options.picture : map},
                     {"unit", depth_unit_of(options, map)},
                     {"scale", options.depth_scale.value_or(1.0)}};
  if (options.disparity)
    spec["stereo"] = {
        {"focal_px", *options.focal_px}, {"baseline_m", *options.baseline_m}, {"doffs_px", options.doffs_px}};
  if (!options.rack_focus_D.empty()) spec["rack_focus_D"] = options.rack_focus_D;
  if (!options.pupil_sequence_mm.empty()) spec["pupil_sequence_mm"] = options.pupil_sequence_mm;
  if (is_sequence(options)) spec["frames"] = options.frames;
  return spec;
}

/// Where the eye is written.
std::string eye_file(const SeeOptions& options) {
  return options.eye.empty() ? command_line_source : named_document_file(options.eye, {"", "--eye"}, "eye").string();
}

Json eye_of(const CommonOptions& common, const std::string& file) {
  const bool alone = file == command_line_source;
  if (alone && common.prescription.empty())
    throw InputError("", "--eye", "nothing", "the file of an eye, or --rx \"-2.00 -1.50 x 30\"");
  Json eye = alone ? Json{{"format", "sturm.eye/1"}, {"pupil_diameter_mm", 4}} : eye_object(file, {});
  apply_eye_options_to(eye, common, {file, ""});
  return eye;
}

class SeeRun {
 public:
  SeeRun(const CommonOptions& common, const SeeOptions& options)
      : options_(options),
        inputs_(read_see_inputs(options)),
        eye_file_(eye_file(options)),
        eye_(eye_of(common, eye_file_)) {
    facts_.threads = thread_count(common);
    facts_.started_utc = utc_now();
    facts_.input_files = inputs_.files;
    if (eye_file_ != command_line_source) facts_.input_files.push_back(eye_file_);
    parts_ = options.parts.value_or(options.error ? parts_for_error(*options.error) : usual_parts);
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
      write_seen(frame.file, seen.radiance, options_, spec);
      facts_.seconds["writing"] += writing.seconds();
      Json entry = counters_of(seen);
      entry["file"] = frame.file.filename().string();
      entry["accommodation_D"] = settings.accommodation_D;
      entry["pupil_diameter_mm"] = 2e3 * settings.eye.pupil_radius_m;
      counters["frames"].push_back(std::move(entry));
    }
    fs::path beside(options_.output);
    if (options_.film) counters["film"] = join_frames(fs::path(beside).replace_extension()).filename().string();
    facts_.seconds["total"] = total_.seconds();
    write_file_atomically(beside.replace_extension(".manifest.json"),
                          json_text(manifest(facts_, spec, counters, inputs_.notes), 1) + "\n");
  }

 private:
  SeeSettings settings_of(const Frame& frame) {
    const Json document = eye_document(options_, frame, eye_);
    validate(document, "eye", eye_file_);
    const EyeSpec spec = read_eye_spec(document, {eye_file_, ""});
    if (frames_.empty()) inputs_.notes.insert(inputs_.notes.end(), spec.notes.begin(), spec.notes.end());
    SeeSettings settings;
    settings.eye = spec.eye;
    settings.accommodation_D = accommodation_of(spec.eye, eye_file_, options_, inputs_);
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
  std::string eye_file_;
  Json eye_;
  RunFacts facts_;
  int parts_ = usual_parts;
  std::vector<std::pair<Frame, SeeSettings>> frames_;
};

}  // namespace

int see_command(const CommonOptions& common, const SeeOptions& options) {
  if (!options.disparity_file.empty() && !options.depth.empty())
    throw InputError("", "--disparity", "\"" + options.disparity_file + "\"", "one depth map, beside --depth no other");
  const bool png = has_suffix(options.output, ".png");
  if (!options.explain && !png && !has_suffix(options.output, ".exr"))
    throw InputError("", "--output", "\"" + options.output + "\"", "a name that ends in .png or .exr");
  if (options.film && (!is_sequence(options) || !png))
    throw InputError("", "--film", "no sequence of PNG files", "--rack-focus-D or --pupil-sequence-mm, and -o X.png");
  if (options.film) require_ffmpeg();
  SeeRun run(common, options);
  if (options.explain)
    run.explain();
  else
    run.write();
  return 0;
}

}  // namespace sturm
