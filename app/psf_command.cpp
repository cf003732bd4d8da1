#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/option_values.h"
#include "app/several_documents.h"
#include "app/text_answers.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/json/values.h"
#include "stages/image_files.h"
#include "stages/psf_pictures.h"

namespace sturm {

namespace {

int answer_point_spreads(const CommonOptions& options, const PsfOptions& files) {
  const std::filesystem::path exr(files.images);
  if (!files.images.empty() && !has_suffix(exr, ".exr"))
    throw InputError("", "--images", "\"" + files.images + "\"", "a name that ends in .exr");
  Json document = load_configuration(
      options,
      {{"format", "sturm.psf/1"}, {"eye", {{"pupil_diameter_mm", 4}}}, {"lights", {{{"wavelength_nm", 555}}}}});
  if (!files.distances_m.empty() && document.is_object()) {
    document.erase("defocus_D");
    document["distances_m"] = Json::array();
    for (const std::string& text : files.distances_m)
      document["distances_m"].push_back(distance_json(distance_option(text, "--distance")));
  }
  if (options.print_config) return print_configuration(document, options.file, files.output);
  require_answer_name(files.output, AnswerKind::Json);
  const PsfSpec spec = read_psf_spec(document, options.file);
  if (!files.output.empty()) require_writable(files.output);
  if (!files.images.empty()) require_writable(exr);
  const PointSpreads spreads = point_spreads(spec, options.file);
  if (!files.images.empty()) {
    write_exr_parts(exr, psf_parts(spec, spreads));
    write_png(std::filesystem::path(exr).replace_extension(".png"), psf_sheet(spec, spreads), 1.0);
  }
  write_result(psf_result(spec, spreads), files.output);
  return 0;
}

}  // namespace

int psf_command(const CommonOptions& given, const PsfOptions& files) {
  std::vector<std::string> images(std::max<std::size_t>(1, given.files.size()), files.images);
  if (!files.images.empty() && !given.files.empty()) images = outputs_of(given.files, files.images, ".exr", "--images");
  auto image = images.begin();
  return for_each_document(given, files.output, ".json", [&](const CommonOptions& options, const std::string& output) {
    return answer_point_spreads(with_source(options), {files.distances_m, output, *image++});
  });
}

}  // namespace sturm
