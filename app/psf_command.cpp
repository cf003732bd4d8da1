#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "stages/image_files.h"
#include "stages/psf_pictures.h"

namespace sturm {

int psf_command(const CommonOptions& given, const PsfOptions& files) {
  const CommonOptions options = with_source(given);
  const std::filesystem::path exr(files.images);
  if (!files.images.empty() && !has_suffix(exr, ".exr"))
    throw InputError("", "--images", "\"" + files.images + "\"", "a name that ends in .exr");
  const Json document = load_configuration(
      options,
      {{"format", "sturm.psf/1"}, {"eye", {{"pupil_diameter_mm", 4}}}, {"lights", {{{"wavelength_nm", 555}}}}});
  if (options.print_config) return print_configuration(document, options.file, files.output);
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

}  // namespace sturm
