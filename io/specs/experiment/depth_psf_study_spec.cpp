#include "io/specs/experiment/depth_psf_study_spec.h"

#include <nlohmann/json.hpp>

#include "io/json/named_file.h"
#include "io/json/unique_ids.h"
#include "io/specs/wavefront_table.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

SpreadMapSpec read_map(const Json& value) {
  SpreadMapSpec map;
  for (const Json& mm : value["pupil_diameters_mm"])
    map.pupil_diameters_m.push_back(metres_per_millimetre * mm.get<double>());
  map.defocus_D = value["defocus_D"].get<std::vector<double>>();
  map.wavelength_nm = value["wavelength_nm"].get<double>();
  map.step_nm = value["step_nm"].get<double>();
  map.cell_arcmin = value["cell_arcmin"].get<double>();
  return map;
}

MeasuredEyes read_eyes(const Json& value, const Source& where, std::vector<std::string>& input_files) {
  MeasuredEyes eyes{value["id"].get<std::string>(), value["title"].get<std::string>(),
                    metres_per_millimetre * value["pupil_diameter_mm"].get<double>()};
  const auto file = existing_file(value["file"], where / "file", "the path of a table of measured wavefronts");
  eyes.coefficients_um = read_wavefront_table(file);
  input_files.push_back(file.string());
  return eyes;
}

BandingSpec read_banding(const Json& value, const Source& where) {
  BandingSpec banding{value["nearest_m"].get<double>(), value["farthest_m"].get<double>(),
                      value["reach_px_per_D"].get<double>(), value["spacings_px"].get<std::vector<double>>()};
  if (!(banding.farthest_m > banding.nearest_m))
    (where / "farthest_m").fail(value["farthest_m"], "a distance beyond \"nearest_m\"");
  return banding;
}

}  // namespace

DepthPsfStudySpec read_depth_psf_study(const Json& value, const Source& where) {
  DepthPsfStudySpec study;
  if (value.contains("map")) study.map = read_map(value["map"]);
  require_unique_ids(value["eyes"], where / "eyes");
  for (std::size_t i = 0; i < value["eyes"].size(); ++i)
    study.eyes.push_back(read_eyes(value["eyes"][i], where / "eyes" / i, study.input_files));
  if (value.contains("banding")) study.banding = read_banding(value["banding"], where / "banding");
  return study;
}

}  // namespace sturm
