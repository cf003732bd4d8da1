#include "io/specs/experiment/sin2_study_spec.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "io/json/named_file.h"
#include "io/specs/prescription_table.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

std::string grid_id(const Prescription& rx) {
  char text[64];
  if (rx.cylinder_D == 0.0)
    std::snprintf(text, sizeof text, "%+.2f", rx.sphere_D);
  else
    std::snprintf(text, sizeof text, "%+.2f %+.2f × %g", rx.sphere_D, rx.cylinder_D, rx.axis_deg);
  return text;
}

std::string group_name(double sphere_D) {
  char text[32];
  std::snprintf(text, sizeof text, "sphere_%+.2f", sphere_D);
  return text;
}

void add_grid(Sin2StudySpec& study, const Json& grid, const Source& where) {
  study.spheres_D = grid["spheres_D"].get<std::vector<double>>();
  study.cylinders_D = grid["cylinders_D"].get<std::vector<double>>();
  study.axes_deg = grid["axes_deg"].get<std::vector<double>>();
  for (std::size_t s = 0; s < study.spheres_D.size(); ++s) {
    const std::size_t begin = study.eyes.size();
    for (const double cylinder : study.cylinders_D)
      for (const double axis : study.axes_deg) {
        const Prescription rx{study.spheres_D[s], cylinder, axis, 0.0};
        make_eye(rx, study.pupil_diameters_m.front(), study.accommodations.front(), where);
        study.eyes.push_back({grid_id(rx), rx});
        if (cylinder == 0.0) break;
      }
    study.groups.push_back({group_name(study.spheres_D[s]), begin, study.eyes.size()});
  }
  study.grid_eyes = study.eyes.size();
}

void add_real_eyes(Sin2StudySpec& study, const Json& population, const Source& where) {
  const auto file = existing_file(population["file"], where / "file", "the path of a table of prescriptions");
  study.input_files.push_back(file.string());
  const std::size_t begin = study.eyes.size();
  for (TabledPrescription& eye :
       read_prescription_table(file, metres_per_millimetre * population["vertex_distance_mm"].get<double>()))
    study.eyes.push_back({std::move(eye.id), eye.prescription});
  study.groups.push_back({"real_eyes", begin, study.eyes.size()});
}

std::size_t index_of(double value, const std::vector<double>& list, const Json& given, const Source& where,
                     const char* expected) {
  const auto at = std::find(list.begin(), list.end(), value);
  if (at == list.end()) where.fail(given, expected);
  return static_cast<std::size_t>(at - list.begin());
}

void read_reference(Sin2StudySpec& study, const Json& value, const Source& where) {
  study.reference_pupil =
      index_of(metres_per_millimetre * value["pupil_diameter_mm"].get<double>(), study.pupil_diameters_m,
               value["pupil_diameter_mm"], where / "pupil_diameter_mm", "one of \"pupil_diameters_mm\"");
  const double distance = read_distance(value["distance_m"], where / "distance_m");
  study.reference_distance =
      index_of(distance, study.distances_m, value["distance_m"], where / "distance_m", "one of \"distances_m\"");
  const auto focused = [&](const Accommodation& a) {
    const auto* fixed = std::get_if<FixedAccommodation>(&a);
    return fixed && fixed->focus_distance_m == distance;
  };
  const auto at = std::find_if(study.accommodations.begin(), study.accommodations.end(), focused);
  if (at == study.accommodations.end())
    (where / "distance_m")
        .fail(value["distance_m"], "a distance that one of \"accommodations\" states as its focus_distance_m");
  study.reference_accommodation = static_cast<std::size_t>(at - study.accommodations.begin());
}

Sin2GalleryView read_gallery_view(const Json& value, const Source& where) {
  Sin2GalleryView view;
  view.id = value["id"].get<std::string>();
  view.title = value["title"].get<std::string>();
  view.eye = make_eye(read_prescription(value["prescription"], where / "prescription"),
                      metres_per_millimetre * value["pupil_diameter_mm"].get<double>(),
                      read_accommodation(value["accommodation"], where / "accommodation"), where / "prescription");
  view.distance_m = read_distance(value["distance_m"], where / "distance_m");
  return view;
}

}  // namespace

Sin2StudySpec read_sin2_study(const Json& value, const Source& where) {
  Sin2StudySpec study;
  for (std::size_t i = 0; i < value["distances_m"].size(); ++i)
    study.distances_m.push_back(read_distance(value["distances_m"][i], where / "distances_m" / i));
  for (const Json& mm : value["pupil_diameters_mm"])
    study.pupil_diameters_m.push_back(metres_per_millimetre * mm.get<double>());
  for (std::size_t i = 0; i < value["accommodations"].size(); ++i)
    study.accommodations.push_back(read_accommodation(value["accommodations"][i], where / "accommodations" / i));
  const Json &rule = value["quadrature"], &rings = value["rings"];
  study.quadrature = {rule["radial"].get<int>(), rule["azimuthal"].get<int>()};
  study.rings = {PupilSampling::Rings, rings["count"].get<int>(), rings["angle_factor"].get<int>()};
  add_grid(study, value["grid"], where / "grid");
  if (value.contains("real_eyes")) add_real_eyes(study, value["real_eyes"], where / "real_eyes");
  read_reference(study, value["reference"], where / "reference");
  study.gallery_rays = value["gallery_rays"].get<std::uint64_t>();
  const Json& gallery = value["gallery"];
  for (std::size_t i = 0; i < gallery.size(); ++i)
    study.gallery.push_back(read_gallery_view(gallery[i], where / "gallery" / i));
  return study;
}

}  // namespace sturm
