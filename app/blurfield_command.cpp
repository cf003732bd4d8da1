#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "conoid/blur_field/field_exr.h"
#include "experiments/figures/blur_field_layers.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/json/json_text.h"
#include "io/json/manifest.h"
#include "stages/blur_field_stage.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

/// The field that is computed where no document says more.
Json usual_field() {
  return {{"format", "sturm.blurfield/1"},
          {"eye", {{"pupil_diameter_mm", 4}}},
          {"field", {{"hfov_deg", 60}, {"directions", {32, 32}}}}};
}

}  // namespace

int blurfield_command(const CommonOptions& given, const BlurFieldOptions& files) {
  const CommonOptions options = with_source(given);
  const Json document = load_configuration(options, usual_field());
  if (options.print_config) return print_configuration(document, options.file, files.output);
  const std::filesystem::path exr(files.output);
  if (!has_suffix(exr, ".exr"))
    throw InputError("", "--output", "\"" + files.output + "\"", "a name that ends in .exr");
  if (!files.layers.empty() && !has_suffix(files.layers, ".svg"))
    throw InputError("", "--layers", "\"" + files.layers + "\"", "a name that ends in .svg");
  const BlurFieldSpec spec = read_blur_field_spec(document, options.file);
  require_writable(exr);
  if (!files.layers.empty()) require_writable(files.layers);

  const Stopwatch total;
  RunFacts facts;
  facts.threads = thread_count(options);
  facts.started_utc = utc_now();
  facts.input_files = spec.input_files;
  if (is_in_file(options)) facts.input_files.insert(facts.input_files.begin(), options.file);
  BlurField field = compute_blur_field(spec);
  Stopwatch writing;
  write_blur_field(exr, field.grid, field.directions, field.analytic ? &*field.analytic : nullptr,
                   field.voxels ? &*field.voxels : nullptr, {{"sturm.spec", spec.resolved->dump()}});
  if (!files.layers.empty()) write_file_atomically(files.layers, layers_svg(spec, field.directions));
  facts.seconds = field.seconds;
  facts.seconds["writing"] = writing.seconds();
  facts.seconds["total"] = total.seconds();
  std::filesystem::path beside = exr;
  write_file_atomically(beside.replace_extension(".manifest.json"),
                        json_text(manifest(facts, *spec.resolved, field.summary, spec.notes), 1) + "\n");

  Json summary = {{"format", "sturm.blurfield_result/1"}};
  summary.update(field.summary);
  summary["seconds"] = facts.seconds;
  write_result(summary, "");
  return 0;
}

}  // namespace sturm
