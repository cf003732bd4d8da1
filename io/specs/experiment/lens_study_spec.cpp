#include "io/specs/experiment/lens_study_spec.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/suggest.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

std::vector<double> ascending(const Json& list, const Source& where) {
  for (std::size_t i = 1; i < list.size(); ++i)
    if (!(list[i].get<double>() > list[i - 1].get<double>()))
      (where / i).fail(list[i], "a number above the one before it");
  return list.get<std::vector<double>>();
}

StudyLens read_lens(const Json& value, const Source& where, const LensStudySpec& study,
                    std::vector<std::string>& input_files) {
  StudyLens lens;
  lens.id = value["id"].get<std::string>();
  lens.note = value["note"].get<std::string>();
  lens.prescription = read_prescription(value["prescription"], where / "prescription");
  const Eye eye =
      make_eye(lens.prescription, study.pupil_diameters_m.front(), study.accommodation, where / "prescription");
  SpectaclesSpec worn = read_spectacles(value["lens"], where / "lens", eye);
  if (!worn.lens) (where / "lens").fail(value["lens"], "a lens, or the path of a lens file");
  lens.lens = *worn.lens;
  for (std::string& file : worn.input_files)
    if (std::find(input_files.begin(), input_files.end(), file) == input_files.end())
      input_files.push_back(std::move(file));
  return lens;
}

std::size_t lens_named(const Json& id, const Source& where, const std::vector<StudyLens>& lenses) {
  std::vector<std::string> ids;
  for (const StudyLens& lens : lenses) {
    if (lens.id == id) return ids.size();
    ids.push_back(lens.id);
  }
  throw InputError(where.file, where.pointer, compact(id) + did_you_mean(id.get<std::string>(), ids),
                   one_of(ids) + " (ids of the lenses)");
}

WideGaze read_wide_gaze(const Json& value, const Source& where, const std::vector<StudyLens>& lenses) {
  WideGaze gaze;
  gaze.lens = lens_named(value["lens"], where / "lens", lenses);
  gaze.azimuths_deg = ascending(value["azimuths_deg"], where / "azimuths_deg");
  gaze.distance_m = read_distance(value["distance_m"], where / "distance_m");
  gaze.pupil_diameter_m = metres_per_millimetre * value["pupil_diameter_mm"].get<double>();
  return gaze;
}

/// The two pupils between which orders are fitted; both must be among those that are traced.
void read_order_pupils(const Json& value, const Source& where, LensStudySpec& study) {
  const Json& pair = value["order_pupil_diameters_mm"];
  const std::vector<double> mm = ascending(pair, where / "order_pupil_diameters_mm");
  for (std::size_t i = 0; i < mm.size(); ++i) {
    const Json& all = value["pupil_diameters_mm"];
    if (std::find(all.begin(), all.end(), mm[i]) == all.end())
      (where / "order_pupil_diameters_mm" / i).fail(pair[i], "one of \"pupil_diameters_mm\"");
  }
  study.order_small_m = metres_per_millimetre * mm[0];
  study.order_large_m = metres_per_millimetre * mm[1];
}

}  // namespace

LensStudySpec read_lens_study(const Json& value, const Source& where) {
  LensStudySpec study;
  study.rotation_center_m = metres_per_millimetre * value["rotation_center_mm"].get<double>();
  study.eccentricities_deg = ascending(value["eccentricities_deg"], where / "eccentricities_deg");
  study.directions_deg = value["directions_deg"].get<std::vector<double>>();
  for (std::size_t i = 0; i < value["distances_m"].size(); ++i)
    study.distances_m.push_back(read_distance(value["distances_m"][i], where / "distances_m" / i));
  for (const double mm : ascending(value["pupil_diameters_mm"], where / "pupil_diameters_mm"))
    study.pupil_diameters_m.push_back(metres_per_millimetre * mm);
  read_order_pupils(value, where, study);
  study.accommodation = read_accommodation(value["accommodation"], where / "accommodation");
  if (std::holds_alternative<BestAccommodation>(study.accommodation))
    (where / "accommodation")
        .fail(value["accommodation"],
              "\"relaxed\" or \"fixed\": methods that accommodate differently cannot be told from methods that trace "
              "differently");
  const Json& rule = value["quadrature"];
  study.quadrature = {rule["radial"].get<int>(), rule["azimuthal"].get<int>()};
  const Json& lenses = value["lenses"];
  for (std::size_t i = 0; i < lenses.size(); ++i)
    study.lenses.push_back(read_lens(lenses[i], where / "lenses" / i, study, study.input_files));
  if (value.contains("field")) study.wide_gaze = read_wide_gaze(value["field"], where / "field", study.lenses);
  return study;
}

}  // namespace sturm
