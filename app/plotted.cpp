#include "app/plotted.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/configuration.h"
#include "app/eye_options.h"
#include "app/named_documents.h"
#include "app/prescription_option.h"
#include "app/several_documents.h"
#include "experiments/figures/lens_maps.h"
#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/prescription_notation.h"

namespace sturm {

namespace {

constexpr double usual_pupil_mm = 4.0;

Json load(const std::string& file, const std::string& prescription) {
  require_document(file, {"eyes", "lenses"}, "a file");
  CommonOptions common;
  common.file = file;
  common.prescription = prescription;
  return load_configuration(common);
}

NamedLens read_plotted_lens(const Json& document, const std::string& file, const std::string& name) {
  validate(document, "spectacles", file);
  const SpectaclesSpec spec = read_lens_alone(document, {file, ""});
  for (const std::string& note : spec.notes) std::cerr << "note: " << note << "\n";
  return {name, spec.lens.value(), nominal_power(spec, {file, ""})};
}

bool is_lens(const Json& document, const std::string& file) {
  return format_of(document, file) == "spectacles";
}

/// The eye that a lens corrects.
Json corrected_eye(const NamedLens& lens) {
  const Prescription rx = lens.nominal.as_prescription();
  Json text = {{"sphere_D", rx.sphere_D}, {"vertex_distance_mm", 1e3 * lens.lens.vertex_distance_m}};
  if (rx.cylinder_D != 0.0) {
    text["cylinder_D"] = rx.cylinder_D;
    text["axis_deg"] = rx.axis_deg;
  }
  return {{"format", "sturm.eye/1"}, {"prescription", text}};
}

PlottedEye with_eye(PlottedEye plotted, const WearerOptions& worn) {
  if (!plotted.eye.contains("pupil_diameter_mm")) plotted.eye["pupil_diameter_mm"] = usual_pupil_mm;
  apply_wearer(plotted.eye, worn, {plotted.file, ""});
  validate(plotted.eye, "eye", plotted.file);
  const EyeSpec spec = read_eye_spec(plotted.eye, {plotted.file, ""});
  for (const std::string& note : spec.notes) std::cerr << "note: " << note << "\n";
  plotted.worn.eye = spec.eye;
  return plotted;
}

PlottedEye eye_in(const Json& document, const std::string& file, const std::string& name, const WearerOptions& worn) {
  PlottedEye plotted{name, {}, {}, file};
  const std::string format = format_of(document, file);
  if (format == "eye") {
    plotted.eye = document;
    return with_eye(plotted, worn);
  }
  validate(document, format, file);
  if (!document.contains("eye"))
    throw InputError(file, "/format", document.at("format").dump(), "an eye, a lens, or a document with an \"eye\"");
  plotted.eye = eye_object(document["eye"], {file, "/eye"});
  plotted = with_eye(plotted, worn);
  if (document.contains("spectacles"))
    plotted.worn.spectacles = read_spectacles(document["spectacles"], {file, "/spectacles"}, plotted.worn.eye).lens;
  return plotted;
}

}  // namespace

PlottedEye eye_behind(const NamedLens& lens, const std::string& file, const WearerOptions& worn) {
  PlottedEye plotted{lens.name, {}, corrected_eye(lens), file};
  plotted = with_eye(plotted, worn);
  plotted.worn.spectacles = lens.lens;
  return plotted;
}

std::vector<PlottedEye> plotted_eyes(const PlotOptions& options) {
  std::vector<PlottedEye> eyes;
  if (!options.prescription.empty()) read_notation(options.prescription, {"", "--rx"});
  if (options.files.empty()) {
    if (options.prescription.empty()) throw InputError("", "FILE", "nothing", "a file, or a prescription by --rx");
    const Json eye = {{"format", "sturm.eye/1"}, {"prescription", options.prescription}};
    eyes.push_back(with_eye({options.prescription, {}, eye, "--rx"}, options.worn));
  }
  const std::vector<std::string> names = document_names(options.files);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& file = options.files[i];
    const Json document = load(file, options.prescription);
    eyes.push_back(is_lens(document, file) ? eye_behind(read_plotted_lens(document, file, names[i]), file, options.worn)
                                           : eye_in(document, file, names[i], options.worn));
  }
  if (options.spectacles.empty()) return eyes;
  const Json document = load(options.spectacles, "");
  if (!is_lens(document, options.spectacles))
    throw InputError(options.spectacles, "/format", document.at("format").dump(), "\"sturm.spectacles/1\"");
  validate(document, "spectacles", options.spectacles);
  for (PlottedEye& eye : eyes) {
    eye.worn.spectacles = read_spectacles(document, {options.spectacles, ""}, eye.worn.eye).lens;
    eye.name += " behind " + document_name(options.spectacles);
  }
  return eyes;
}

Json usual_lens() {
  return {{"format", "sturm.spectacles/1"}, {"single_vision", {{"center_thickness_mm", 2}, {"refractive_index", 1.5}}}};
}

std::vector<NamedLens> plotted_lenses(const PlotOptions& options) {
  std::vector<NamedLens> lenses;
  if (options.files.empty()) {
    if (options.prescription.empty()) throw InputError("", "FILE", "nothing", "a lens, or a prescription by --rx");
    Json lens = usual_lens();
    apply_prescription(lens, options.prescription, "--rx");
    lenses.push_back(read_plotted_lens(lens, "--rx", options.prescription));
  }
  const std::vector<std::string> names = document_names(options.files);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& file = options.files[i];
    const Json document = load(file, options.prescription);
    if (!is_lens(document, file))
      throw InputError(file, "/format", document.at("format").dump(), "\"sturm.spectacles/1\"");
    lenses.push_back(read_plotted_lens(document, file, names[i]));
  }
  return lenses;
}

std::vector<NamedEye> named_eyes(const std::vector<PlottedEye>& eyes) {
  std::vector<NamedEye> named;
  for (const PlottedEye& eye : eyes) named.push_back({eye.name, eye.worn});
  return named;
}

void require_few_panels(std::size_t panels) {
  constexpr std::size_t most_panels = 6;
  if (panels > most_panels)
    throw InputError("", "FILE, --distance", std::to_string(panels) + " panels side by side", "at most 6");
}

}  // namespace sturm
