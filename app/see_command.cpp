#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/film.h"
#include "app/see_document.h"
#include "app/see_inputs.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/files/plain_file.h"
#include "io/images/exr.h"
#include "io/json/json_text.h"
#include "io/json/manifest.h"
#include "stages/image_files.h"
#include "stages/see_stage.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

/// The file of each frame of a sequence, or of the only picture.
std::vector<fs::path> files_of_frames(const SeeSpec& spec, const fs::path& output) {
  if (!spec.sequence) return {output};
  std::vector<fs::path> files;
  for (std::size_t i = 1; i <= spec.frames.size(); ++i)
    files.push_back(output.parent_path() /
                    (output.stem().string() + formatted("_%04d", static_cast<int>(i)) + output.extension().string()));
  return files;
}

void write_seen(const fs::path& file, const Image& radiance, const SeeSpec& spec, const Json& resolved) {
  if (has_suffix(file, ".exr"))
    write_exr(file, LayeredImage{{{"", radiance}}, {{"sturm.see", json_text(resolved)}}});
  else
    write_png(file, radiance, spec.exposure, spec.png_bits);
}

/// The document with every default spelt out, the width of a pixel included.
Json resolved_with_pixels(const SeeSpec& spec, double pixel_slope) {
  Json resolved = *spec.resolved;
  for (const char* key : {"vfov_deg", "hfov_deg"}) resolved.erase(key);
  resolved["pixel_slope"] = pixel_slope;
  return resolved;
}

class SeeRun {
 public:
  SeeRun(const CommonOptions& common, const SeeSpec& spec) : spec_(spec), inputs_(read_see_inputs(spec)) {
    facts_.threads = thread_count(common);
    facts_.started_utc = utc_now();
    facts_.input_files = spec.input_files;
    if (is_in_file(common)) facts_.input_files.insert(facts_.input_files.begin(), common.file);
    inputs_.notes.insert(inputs_.notes.end(), spec.notes.begin(), spec.notes.end());
  }

  void explain() { std::cout << explanation_of(seen_by(spec_.frames.front())); }

  void write(const fs::path& output, bool film) {
    const std::vector<fs::path> files = files_of_frames(spec_, output);
    for (const fs::path& file : files) require_writable(file);
    if (spec_.sequence)  // no frame is written of one that cannot be finished
      for (const SeeingEye& frame : spec_.frames) require_blur(inputs_.picture, inputs_.layers, settings_of(frame));
    const Json resolved = resolved_with_pixels(spec_, inputs_.pixel_slope);
    Json counters = {{"filled_holes", inputs_.filled_holes}, {"frames", Json::array()}};
    for (std::size_t i = 0; i < files.size(); ++i) {
      const SeenPicture seen = seen_by(spec_.frames[i]);
      Stopwatch writing;
      write_seen(files[i], seen.radiance, spec_, resolved);
      facts_.seconds["writing"] += writing.seconds();
      Json entry = counters_of(seen);
      entry["file"] = files[i].filename().string();
      entry["accommodation_D"] = spec_.frames[i].accommodation_D;
      entry["pupil_diameter_mm"] = 2e3 * spec_.frames[i].eye.pupil_radius_m;
      counters["frames"].push_back(std::move(entry));
    }
    fs::path beside = output;
    if (film) counters["film"] = join_frames(fs::path(beside).replace_extension()).filename().string();
    facts_.seconds["total"] = total_.seconds();
    write_file_atomically(beside.replace_extension(".manifest.json"),
                          json_text(manifest(facts_, resolved, counters, inputs_.notes), 1) + "\n");
  }

 private:
  SeeSettings settings_of(const SeeingEye& frame) const {
    SeeSettings settings;
    settings.eye = frame.eye;
    settings.accommodation_D = frame.accommodation_D;
    settings.pixel_slope = inputs_.pixel_slope;
    settings.psf = spec_.psf;
    settings.chromatic = spec_.chromatic;
    settings.parts = spec_.parts;
    return settings;
  }

  SeenPicture seen_by(const SeeingEye& frame) {
    SeenPicture seen = see_picture(inputs_.picture, inputs_.layers, settings_of(frame));
    for (const auto& [part, seconds] : seen.seconds) facts_.seconds[part] += seconds;
    return seen;
  }

  const SeeSpec& spec_;
  Stopwatch total_;
  SeeInputs inputs_;
  RunFacts facts_;
};

/// Throws InputError for a name of the result that does not fit what is asked for.
void require_output(const SeeSpec& spec, const SeeOptions& options) {
  const bool png = has_suffix(options.output, ".png");
  if (!png && !has_suffix(options.output, ".exr"))
    throw InputError("", "--output", "\"" + options.output + "\"", "a name that ends in .png or .exr");
  if (!options.film) return;
  if (!spec.sequence || !png)
    throw InputError("", "--film", "no sequence of PNG files", "--rack-focus-D or --pupil-sequence-mm, and -o X.png");
  require_ffmpeg();
}

}  // namespace

int see_command(const CommonOptions& given, const SeeOptions& options) {
  if (!options.disparity_file.empty() && !options.depth.empty())
    throw InputError("", "--disparity", "\"" + options.disparity_file + "\"", "one depth map, beside --depth no other");
  const CommonOptions common = with_see_source(given, options);
  const Json document = see_document(common, options);
  if (common.print_config) return print_configuration(document, common.file, options.output);
  const SeeSpec spec = read_see_spec(document, common.file);
  if (!options.explain) require_output(spec, options);
  SeeRun run(common, spec);
  if (options.explain)
    run.explain();
  else
    run.write(options.output, options.film);
  return 0;
}

}  // namespace sturm
