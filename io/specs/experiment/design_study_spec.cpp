#include "io/specs/experiment/design_study_spec.h"

#include <nlohmann/json.hpp>

#include "io/json/named_file.h"
#include "io/json/values.h"
#include "io/specs/experiment/input_files.h"
#include "io/specs/eye_spec.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

StudyDesign read_design(const Json& value, const Source& where, std::vector<std::string>& input_files) {
  StudyDesign design;
  design.id = value["id"].get<std::string>();
  design.note = value.value("note", "");
  const Json& lens = value["lens"];
  if (lens.is_string()) {
    design.file = named_document_file(lens, where / "lens", "spectacles").string();
    design.document = load_named_document(lens, where / "lens", "spectacles");
    add_files(input_files, {design.file});
  } else {
    design.file = where.file;
    design.document = lens;
  }
  design.made = read_lens_alone(design.document, lens.is_string() ? Source{design.file, ""} : where / "lens");
  if (!design.made.lens) (where / "lens").fail(lens, "a lens, or the path of a lens file");
  add_files(input_files, design.made.input_files);
  return design;
}

/// So many rows of a table, evenly spread over it.
std::vector<TabledPrescription> some_of(std::vector<TabledPrescription> all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<TabledPrescription> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
  return some;
}

/// Wearers need designs that can be made for anybody.
void require_maker(const StudyDesign& design, const Json& lens, const Source& where) {
  if (!design.document.contains("single_vision") && !design.document.contains("progressive"))
    where.fail(lens, "a single_vision or progressive lens, which can be made for each of the wearers");
}

WearerPopulation read_population(const Json& value, const Source& where, std::vector<std::string>& input_files) {
  const std::string file = existing_file(value["file"], where / "file", "a table of prescriptions").string();
  add_files(input_files, {file});
  WearerPopulation population;
  population.wearers = read_prescription_table(file, metres_per_millimetre * value["vertex_distance_mm"].get<double>());
  if (value.contains("at_most"))
    population.wearers = some_of(std::move(population.wearers), value["at_most"].get<std::size_t>());
  if (value.contains("amplitude_D")) population.amplitude_D = value["amplitude_D"].get<double>();
  return population;
}

}  // namespace

DesignStudySpec read_design_study(const Json& value, const Source& where) {
  DesignStudySpec study;
  for (std::size_t i = 0; i < value["designs"].size(); ++i)
    study.designs.push_back(read_design(value["designs"][i], where / "designs" / i, study.input_files));
  for (std::size_t i = 0; i < value["distances_m"].size(); ++i)
    study.distances_m.push_back(read_distance(value["distances_m"][i], where / "distances_m" / i));
  study.pupil_diameter_m = metres_per_millimetre * value["pupil_diameter_mm"].get<double>();
  study.amplitude_D = value["amplitude_D"].get<double>();
  study.clear_D = value["clear_D"].get<double>();
  study.reach_deg = value["reach_deg"].get<double>();
  study.step_deg = value["step_deg"].get<double>();
  if (value.contains("range_D")) study.range_D = value["range_D"].get<double>();
  study.rotation_center_m = metres_per_millimetre * value["rotation_center_mm"].get<double>();
  if (value.contains("wearers"))
    study.population = read_population(value["wearers"], where / "wearers", study.input_files);
  for (std::size_t i = 0; study.population && i < study.designs.size(); ++i)
    require_maker(study.designs[i], value["designs"][i]["lens"], where / "designs" / i / "lens");
  return study;
}

}  // namespace sturm
