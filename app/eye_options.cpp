#include "app/eye_options.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/configuration.h"
#include "app/option_values.h"
#include "app/prescription_option.h"
#include "io/files/error.h"
#include "io/json/values.h"
#include "io/specs/eye_spec.h"
#include "io/specs/prescription_notation.h"

namespace sturm {

namespace {

bool says_something(const WearerOptions& w) {
  return w.vertex_mm || w.pupil_mm || w.age_years || w.amplitude_D || !w.focus_m.empty();
}

/// The prescription as numbers, stated for a lens at this distance. A text that states another one is refused.
void set_vertex(Json& eye, double vertex_mm, const Source& where) {
  const auto rx = eye.find("prescription");
  if (rx == eye.end())
    throw InputError("", "--vertex", Json(vertex_mm).dump(), "an eye with a prescription: this one has none");
  if (rx->is_string()) {
    const NotedPrescription noted = read_notation(rx->get<std::string>(), where / "prescription");
    if (noted.vertex_distance_mm && *noted.vertex_distance_mm != vertex_mm)
      throw InputError("", "--vertex", Json(vertex_mm).dump(),
                       Json(*noted.vertex_distance_mm).dump() + ", as the prescription's text has it, or nothing");
    *rx = prescription_object(noted, where / "prescription");
  }
  if (!rx->is_object()) (where / "prescription").fail(*rx, "a prescription");
  (*rx)["vertex_distance_mm"] = vertex_mm;
}

void set_accommodation(Json& eye, const WearerOptions& w) {
  if (w.age_years) eye["accommodation"] = {{"mode", "best"}, {"age_years", *w.age_years}};
  if (w.amplitude_D) eye["accommodation"] = {{"mode", "best"}, {"amplitude_D", *w.amplitude_D}};
  if (!w.focus_m.empty())
    eye["accommodation"] = {{"mode", "fixed"},
                            {"focus_distance_m", distance_json(distance_option(w.focus_m, "--focus"))}};
}

/// A lens that is made says itself where it sits.
bool apply_to_lens(Json& document, const WearerOptions& w) {
  for (const char* maker : {"single_vision", "progressive"})
    if (const auto made = document.find(maker); made != document.end() && made->is_object()) {
      if (w.vertex_mm) (*made)["vertex_distance_mm"] = *w.vertex_mm;
      return true;
    }
  return false;
}

}  // namespace

std::string path_in_document(const CommonOptions& options, const std::string& path) {
  std::error_code code;
  if (!is_in_file(options) || !std::filesystem::exists(path, code)) return path;
  return std::filesystem::absolute(path).string();
}

void apply_wearer(Json& eye, const WearerOptions& w, const Source& where) {
  if (w.vertex_mm) set_vertex(eye, *w.vertex_mm, where);
  if (w.pupil_mm) eye["pupil_diameter_mm"] = *w.pupil_mm;
  set_accommodation(eye, w);
}

void apply_eye_options(Json& document, const CommonOptions& options) {
  if (!options.worn.eye.empty() && document.is_object()) document["eye"] = path_in_document(options, options.worn.eye);
  if (!options.prescription.empty()) apply_prescription(document, options.prescription, options.file);
  if (!document.is_object()) return;  // the reader says what is wrong
  if (!options.worn.lens.empty()) document["spectacles"] = path_in_document(options, options.worn.lens);
  if (!says_something(options.worn) || apply_to_lens(document, options.worn)) return;
  const Source where{options.file, "/eye"};
  const auto eye = document.find("eye");
  if (eye == document.end()) throw InputError(options.file, "", "no \"eye\"", "a document with an \"eye\"");
  *eye = eye_object(*eye, where);
  if (!eye->is_object()) where.fail(*eye, "an eye");
  apply_wearer(*eye, options.worn, where);
  if (options.worn.pupil_mm && document.contains("pupil_diameter_mm"))
    document["pupil_diameter_mm"] = *options.worn.pupil_mm;
}

}  // namespace sturm
