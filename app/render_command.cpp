#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/option_values.h"
#include "app/several_documents.h"
#include "experiments/run/progress.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/files/output_target.h"
#include "io/files/plain_file.h"
#include "io/images/exr.h"
#include "io/json/json_pointer_set.h"
#include "io/json/json_text.h"
#include "io/json/manifest.h"
#include "stages/image_files.h"
#include "stages/picture_cost.h"
#include "stages/render_stage.h"

namespace sturm {

namespace {

/// Shows nothing where no file was asked for. Throws where it could not be written.
Preview preview_to(const PreviewOptions& options, const RenderSpec& spec) {
  Preview preview;
  preview.interval_s = options.interval_s;
  if (options.file.empty()) return preview;
  const std::filesystem::path png(options.file);
  const std::string given = "\"" + options.file + "\"";
  if (!has_suffix(png, ".png")) throw InputError("", "--preview", given, "a name that ends in .png");
  if (spec.method != RenderMethod::PathTrace)
    throw InputError("", "--preview", given, "a document of type \"path_trace\"");
  require_writable(png);
  if (output_target(png).kind != OutputTarget::Kind::File)
    throw InputError("", "--preview", given, "a file that can be replaced while the picture grows, no pipe or device");
  preview.show = [png](const Image& radiance) { write_png(png, radiance, 1.0); };
  return preview;
}

/// The view with what the options change.
Json view_document(const CommonOptions& options, const PreviewOptions& changes) {
  Json document = load_configuration(options);
  if (changes.samples_per_pixel)
    apply_set(document, "/method/samples_per_pixel=" + std::to_string(*changes.samples_per_pixel));
  if (changes.size.empty()) return document;
  const auto [width, height] = pair_option(changes.size, 'x', "--size", "WIDTHxHEIGHT [px], like 480x320");
  apply_set(document, "/camera/resolution=[" + plain_number(width, 9) + "," + plain_number(height, 9) + "]");
  return document;
}

int render_one(const CommonOptions& options, const PreviewOptions& preview_options, const std::string& output) {
  const std::filesystem::path file(output);
  const bool png_alone = has_suffix(file, ".png");
  const Json document = view_document(options, preview_options);
  if (options.print_config) return print_configuration(document, options.file, output);
  if (!png_alone && !has_suffix(file, ".exr"))
    throw InputError("", "--output", "\"" + output + "\"", "a name that ends in .exr or .png");
  const RenderSpec spec = read_render_spec(document, options.file);
  require_writable(file);
  const Preview preview = preview_to(preview_options, spec);

  RunFacts facts;
  facts.threads = thread_count(options);
  facts.seed = spec.seed;
  facts.started_utc = utc_now();
  facts.input_files = spec.input_files;
  if (is_in_file(options)) facts.input_files.insert(facts.input_files.begin(), options.file);
  const double samples =
      static_cast<double>(spec.camera.width) * spec.camera.height * static_cast<double>(spec.samples_per_pixel);
  Progress progress("rendering", samples, "samples", options.quiet);
  RenderOutput result = render_view(
      spec, [&](double fraction) { progress.update(fraction); }, preview);
  facts.seconds = result.seconds;
  facts.seconds["total"] = progress.seconds();

  std::filesystem::path beside = file;
  if (!png_alone) write_exr(file, result.image);
  if (preview.show) preview.show(result.image.layers.at(""));
  write_png(beside.replace_extension(".png"), result.shown(), 1.0);
  write_file_atomically(beside.replace_extension(".manifest.json"),
                        json_text(manifest(facts, *spec.resolved, result.counters, result.notes), 1) + "\n");
  if (!options.quiet) std::fprintf(stderr, "%s\n", cost_of(spec, result).c_str());
  if (!result.warning.empty()) std::fprintf(stderr, "warning: %s\n", result.warning.c_str());
  return 0;
}

}  // namespace

int explain_command(const CommonOptions& given, const PreviewOptions& changes) {
  const CommonOptions options = with_one_document(given, "--explain");
  const RenderSpec spec = read_render_spec(view_document(options, changes), options.file);
  std::fputs(explain_view(spec).c_str(), stdout);
  return 0;
}

int render_command(const CommonOptions& options, const PreviewOptions& preview, const std::string& output) {
  if (!preview.file.empty()) with_one_document(options, "--preview");
  return for_each_document(options, output, ".exr", [&](const CommonOptions& one, const std::string& file) {
    return render_one(one, preview, file);
  });
}

}  // namespace sturm
