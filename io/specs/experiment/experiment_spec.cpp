#include "io/specs/experiment/experiment_spec.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/named_file.h"
#include "io/json/schema.h"
#include "io/json/suggest.h"
#include "io/json/unique_ids.h"
#include "io/specs/experiment/input_files.h"
#include "io/specs/words.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

Accommodation accommodation_of(const Json& value, const Source& where) {
  return value.contains("accommodation") ? read_accommodation(value["accommodation"], where / "accommodation")
                                         : Accommodation{};
}

std::vector<RayModel> ray_models_of(const Json& value, const Source& where) {
  return read_words(value["ray_models"], where / "ray_models", ray_model_words);
}

/// Numbers, or a text in optical notation in their place.
Prescription read_named_prescription(const Json& value, const Source& where) {
  const auto text = value.find("prescription");
  if (text == value.end()) {
    if (!value.contains("sphere_D"))
      throw InputError(where.file, where.pointer, "no \"sphere_D\"",
                       "\"sphere_D\": a number from -40 to 40 (sphere [D]; a myope's is negative), or a "
                       "\"prescription\" such as \"-2.00 -1.50 x 30\"");
    return read_prescription(value, where);
  }
  for (const char* key : {"sphere_D", "cylinder_D", "axis_deg", "vertex_distance_mm"})
    if (value.contains(key)) (where / key).fail(value[key], "no \"" + std::string(key) + "\" beside \"prescription\"");
  const Prescription rx = read_prescription(*text, where / "prescription");
  if (rx.prism_cm_per_m != 0.0) (where / "prescription").fail(*text, "no prism: it has no part in a blur ellipse");
  return rx;
}

EllipseExperiment read_ellipses(const Json& value, const Source& where) {
  EllipseExperiment ellipses;
  const Json& list = value["prescriptions"];
  require_unique_ids(list, where / "prescriptions");
  for (std::size_t i = 0; i < list.size(); ++i)
    ellipses.prescriptions.push_back({list[i]["id"].get<std::string>(), list[i].value("note", ""),
                                      read_named_prescription(list[i], where / "prescriptions" / i)});
  for (std::size_t i = 0; i < value["distances_m"].size(); ++i)
    ellipses.distances_m.push_back(read_distance(value["distances_m"][i], where / "distances_m" / i));
  for (const Json& diameter_mm : value["pupil_diameters_mm"])
    ellipses.pupil_diameters_m.push_back(metres_per_millimetre * diameter_mm.get<double>());
  ellipses.accommodation = accommodation_of(value, where);
  ellipses.ray_models = ray_models_of(value, where);
  ellipses.rays = read_ray_bundle(value.value("rays", Json()), where / "rays", 0.0);
  return ellipses;
}

const Prescription& prescription_named(const Json& id, const Source& where,
                                       const std::optional<EllipseExperiment>& ellipses) {
  std::vector<std::string> ids;
  if (ellipses)
    for (const NamedPrescription& candidate : ellipses->prescriptions) {
      if (candidate.id == id) return candidate.prescription;
      ids.push_back(candidate.id);
    }
  throw InputError(where.file, where.pointer, compact(id) + did_you_mean(id.get<std::string>(), ids),
                   one_of(ids) + " (ids of /ellipses/prescriptions)");
}

PsfExperiment read_psf(const Json& value, const Source& where, const std::optional<EllipseExperiment>& ellipses) {
  PsfExperiment psf;
  psf.id = value["id"].get<std::string>();
  psf.prescription = value["prescription"].get<std::string>();
  psf.eye =
      make_eye(prescription_named(value["prescription"], where / "prescription", ellipses),
               metres_per_millimetre * value["pupil_diameter_mm"].get<double>(), accommodation_of(value, where), where);
  psf.distance_m = read_distance(value["distance_m"], where / "distance_m");
  psf.ray_models = ray_models_of(value, where);
  for (const RayModel ray_model : psf.ray_models)
    require_rays(ray_model, psf.eye.accommodation, where / "accommodation");
  psf.resolution = value["resolution"].get<int>();
  psf.samples_per_pixel = value["samples_per_pixel"].get<std::uint64_t>();
  return psf;
}

Json resolved_experiment(const Json& document) {
  Json resolved = with_defaults(document, "experiment");
  resolved.erase("$schema");
  if (const auto images = resolved.find("images"); images != resolved.end())
    for (Json& image : *images)
      if (!image.contains("sharp_samples_per_pixel")) image["sharp_samples_per_pixel"] = image["samples_per_pixel"];
  // Lenses stay as given: the schema's defaults of one kind of surface are refused for another.
  if (const auto study = resolved.find("lens_study"); study != resolved.end())
    for (std::size_t i = 0; i < (*study)["lenses"].size(); ++i)
      (*study)["lenses"][i]["lens"] = document["lens_study"]["lenses"][i]["lens"];
  if (const auto study = resolved.find("design_study"); study != resolved.end())
    for (std::size_t i = 0; i < (*study)["designs"].size(); ++i)
      (*study)["designs"][i]["lens"] = document["design_study"]["designs"][i]["lens"];
  if (const auto agreement = resolved.find("agreement"); agreement != resolved.end())
    for (std::size_t i = 0; i < agreement->size(); ++i) {
      Json& view = (*agreement)[i];
      if (document["agreement"][i].contains("spectacles")) view["spectacles"] = document["agreement"][i]["spectacles"];
      for (Json& one : view["predictions"])
        if (one.is_object())
          for (const std::string& key : keys_without_meaning(one)) one.erase(key);
    }
  if (const auto figures = resolved.find("figures"); figures != resolved.end())
    for (std::size_t i = 0; i < figures->size(); ++i)
      for (const auto& [key, given] : document["figures"][i].items()) (*figures)[i][key] = given;
  return resolved;
}

/// A benchmark that stands in the experiment or in a file of its own, with the experiment's seed.
BenchSpec read_bench_section(const Json& value, const Source& where, std::uint64_t seed,
                             std::vector<std::string>& input_files) {
  const std::string file =
      value.is_string() ? existing_file(value, where, "the path of a benchmark (sturm.bench/1)").string() : "";
  if (!file.empty()) add_files(input_files, {file});
  Json document = file.empty() ? value : load_json(file);
  if (document.is_object()) document["seed"] = seed;
  return file.empty() ? read_bench(document, where) : read_bench(document, file);
}

/// The sections that are studies of their own; `resolved` is the document with all defaults.
void read_studies(const Json& document, const Json& resolved, const Source& root, ExperimentSpec& spec) {
  if (document.contains("lens_study")) {
    require_unique_ids(document["lens_study"]["lenses"], root / "lens_study" / "lenses");
    spec.lens_study = read_lens_study(resolved["lens_study"], root / "lens_study");
    add_files(spec.input_files, spec.lens_study->input_files);
  }
  if (document.contains("sin2_study")) {
    require_unique_ids(resolved["sin2_study"]["gallery"], root / "sin2_study" / "gallery");
    spec.sin2_study = read_sin2_study(resolved["sin2_study"], root / "sin2_study");
    add_files(spec.input_files, spec.sin2_study->input_files);
  }
  if (document.contains("design_study")) {
    require_unique_ids(document["design_study"]["designs"], root / "design_study" / "designs");
    spec.design_study = read_design_study(resolved["design_study"], root / "design_study");
    add_files(spec.input_files, spec.design_study->input_files);
  }
  if (document.contains("sampling_study")) {
    spec.sampling_study = read_sampling_study(document["sampling_study"], root / "sampling_study");
    add_files(spec.input_files, spec.sampling_study->scene.input_files);
  }
  if (document.contains("depth_psf_study")) {
    spec.depth_psf_study = read_depth_psf_study(resolved["depth_psf_study"], root / "depth_psf_study");
    add_files(spec.input_files, spec.depth_psf_study->input_files);
  }
  if (document.contains("bench")) {
    spec.bench = read_bench_section(document["bench"], root / "bench", spec.seed, spec.input_files);
    add_files(spec.input_files, spec.bench->input_files);
  }
}

}  // namespace

ExperimentSpec read_experiment(const Json& document, const std::string& file) {
  validate(document, "experiment", file);
  const Source root{file, ""};
  Json resolved = resolved_experiment(document);
  ExperimentSpec spec;
  spec.title = document["title"].get<std::string>();
  spec.seed = document.value("seed", spec.seed);
  if (document.contains("gates")) {
    spec.gates = existing_document(document["gates"], root / "gates", "gates", "the path of a gates file");
    spec.input_files.push_back(spec.gates.string());
  }
  if (document.contains("reference")) {
    spec.reference = existing_file(document["reference"], root / "reference", "the path of a reference file");
    add_files(spec.input_files, {spec.reference->string()});
  }
  if (document.contains("baseline")) {
    spec.baseline = path_beside(document["baseline"].get<std::string>(), file);
    if (std::filesystem::is_regular_file(*spec.baseline)) add_files(spec.input_files, {spec.baseline->string()});
  }
  spec.mutations = document.value("mutations", spec.mutations);
  if (!spec.mutations.empty() && spec.gates.empty())
    (root / "mutations").fail(document["mutations"], "\"gates\" beside them, which might notice");
  if (document.contains("ellipses")) spec.ellipses = read_ellipses(document["ellipses"], root / "ellipses");
  read_studies(document, resolved, root, spec);
  const Json figures = document.value("figures", Json::array());
  require_unique_ids(figures, root / "figures");
  for (std::size_t i = 0; i < figures.size(); ++i) {
    spec.figures.push_back(read_figure(figures[i], root / "figures" / i));
    add_files(spec.input_files, spec.figures.back().input_files);
  }
  const Json psfs = document.value("psfs", Json::array());
  require_unique_ids(psfs, root / "psfs");
  for (std::size_t i = 0; i < psfs.size(); ++i)
    spec.psfs.push_back(read_psf(psfs[i], root / "psfs" / i, spec.ellipses));
  spec.pictures = read_pictures(document, root, [&](const Json& id, const Source& where) -> const Prescription& {
    return prescription_named(id, where, spec.ellipses);
  });
  for (const PictureExperiment& picture : spec.pictures) add_files(spec.input_files, picture.input_files);
  if (spec.bench) resolved["bench"] = *spec.bench->resolved;
  spec.resolved = std::make_shared<const Json>(std::move(resolved));
  spec.share_views = (*spec.resolved)["skip"]["same_views"].get<bool>();
  return spec;
}

}  // namespace sturm
