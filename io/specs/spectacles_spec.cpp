#include "io/specs/spectacles_spec.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/files/error.h"
#include "io/json/named_file.h"
#include "io/specs/eye_spec.h"
#include "io/specs/lens_design.h"
#include "io/specs/lens_files/lens_file.h"
#include "io/specs/progressive_spec.h"
#include "io/specs/sag_grid.h"
#include "lensmodel/needed_power.h"
#include "lensmodel/prism.h"
#include "lensmodel/progressive.h"
#include "lensmodel/single_vision.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double smallest_radius_mm = 1.0;

[[noreturn]] void missing(const char* key, const Source& where, const std::string& expected) {
  throw InputError(where.file, where.pointer, "no \"" + std::string(key) + "\"", expected);
}

double required(const Json& value, const char* key, const Source& where, const char* expected) {
  if (!value.contains(key)) missing(key, where, expected);
  return value[key].get<double>();
}

/// 1/R [1/m] of a radius [mm]; null is flat.
double read_curvature(const Json& surface, const char* key, const Source& where) {
  if (!surface.contains(key))
    missing(key, where,
            "\"" + std::string(key) + "\" for a " + surface["type"].get<std::string>() +
                ": a radius [mm], or null where it is flat");
  const Json& radius = surface[key];
  if (radius.is_null()) return 0.0;
  if (!(std::abs(radius.get<double>()) >= smallest_radius_mm))
    (where / key)
        .fail(radius,
              "a radius of at least " + Json(smallest_radius_mm).dump() + " mm either way, or null for a flat surface");
  return 1.0 / (metres_per_millimetre * radius.get<double>());
}

Surface read_named_grid(const Json& value, const Source& where, const char* side, double rim_radius,
                        SpectaclesSpec& spec) {
  if (!value.contains("file"))
    missing("file", where, "\"file\" for a sag_grid: the path of a table of x_mm, y_mm, z_mm");
  const std::string file =
      existing_file(value["file"], where / "file", "the path of a table of x_mm, y_mm, z_mm").string();
  std::optional<double> knot_spacing;
  if (value.contains("knot_spacing_mm")) knot_spacing = metres_per_millimetre * value["knot_spacing_mm"].get<double>();
  const SagGrid grid = read_sag_grid(file, knot_spacing, rim_radius);
  spec.input_files.push_back(file);
  spec.fits.push_back({side, grid.surface.grid().spacing, grid.residual, std::nullopt});
  return grid.surface;
}

Surface read_surface(const Json& value, const Source& where, const char* side, double rim_radius,
                     SpectaclesSpec& spec) {
  const std::string type = value["type"].get<std::string>();
  const auto refuse = [&](std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (value.contains(key)) (where / key).fail(value[key], "no \"" + std::string(key) + "\" for a " + type);
  };
  if (type == "sag_grid") {
    refuse({"radius_mm", "conic_constant", "sweep_radius_mm", "generator_radius_mm", "sweep_meridian_deg"});
    return read_named_grid(value, where, side, rim_radius, spec);
  }
  refuse({"file", "knot_spacing_mm"});
  if (type == "torus") {
    refuse({"radius_mm", "conic_constant"});
    return TorusSurface(read_curvature(value, "sweep_radius_mm", where),
                        read_curvature(value, "generator_radius_mm", where),
                        required(value, "sweep_meridian_deg", where,
                                 "\"sweep_meridian_deg\" for a torus: the meridian of the sweep in TABO degrees"));
  }
  refuse({"sweep_radius_mm", "generator_radius_mm", "sweep_meridian_deg"});
  const double curvature = read_curvature(value, "radius_mm", where);
  if (type == "conic") return ConicSurface{curvature, value.value("conic_constant", 0.0)};
  refuse({"conic_constant"});
  return SphereSurface{curvature};
}

/// A length [m]: stated in millimetres, or that of any lens.
double length_or(const Json& value, const char* key, double otherwise_m) {
  const auto stated = value.find(key);
  return stated == value.end() ? otherwise_m : metres_per_millimetre * stated->get<double>();
}
double vertex_distance(const Json& value) {
  return length_or(value, "vertex_distance_mm", Spectacles{}.vertex_distance_m);
}
double diameter(const Json& value) {
  return length_or(value, "diameter_mm", Spectacles{}.diameter_m);
}

/// How the lens stands before the eye; straight if nothing is said.
Mounting read_mounting(const Json& value) {
  const auto stated = value.find("mounting");
  if (stated == value.end()) return {};
  const Json decentration = stated->value("decentration_mm", Json::array({0.0, 0.0}));
  return {metres_per_millimetre * Eigen::Vector2d(decentration[0].get<double>(), decentration[1].get<double>()),
          radians_per_degree * stated->value("pantoscopic_tilt_deg", 0.0),
          radians_per_degree * stated->value("wrap_deg", 0.0)};
}

/// Stated, or that of the named material.
double read_index(const Json& value, const Source& where, SpectaclesSpec& spec) {
  const auto named = value.find("material");
  if (named == value.end())
    return required(value, "refractive_index", where, "\"refractive_index\": a number from 1 to 4, or \"material\"");
  if (value.contains("refractive_index"))
    (where / "refractive_index").fail(value["refractive_index"], "no \"refractive_index\" beside \"material\"");
  spec.material = lens_material(named->get<std::string>());  // the schema lists the same names
  if (!spec.material) (where / "material").fail(*named, "a known material");
  return spec.material->refractive_index;
}

Spectacles read_two_surfaces(const Json& value, const Source& where, SpectaclesSpec& spec) {
  for (const char* side : {"front", "back"})
    if (!value.contains(side)) missing(side, where, "\"front\" and \"back\", or \"single_vision\", or \"progressive\"");
  Spectacles lens;
  const double rim_radius = 0.5 * diameter(value);
  lens.front = read_surface(value["front"], where / "front", "front", rim_radius, spec);
  lens.back = read_surface(value["back"], where / "back", "back", rim_radius, spec);
  lens.center_thickness_m =
      metres_per_millimetre *
      required(value, "center_thickness_mm", where, "\"center_thickness_mm\": the lens's thickness at its centre [mm]");
  lens.refractive_index = read_index(value, where, spec);
  lens.vertex_distance_m = vertex_distance(value);
  lens.diameter_m = diameter(value);
  lens.mounting = read_mounting(value);
  return lens;
}

/// The back vertex power: stated, or what the eye needs where the lens is worn.
Prescription lens_power(const Json& value, const Source& where, const Eye& eye, double vertex_distance_m) {
  if (const auto stated = value.find("prescription"); stated != value.end()) {
    Prescription rx = read_prescription(*stated, where / "prescription");
    rx.vertex_distance_m = vertex_distance_m;
    return rx;
  }
  return needed_power(eye, vertex_distance_m);
}

/// What single-vision and progressive lenses have in common.
SingleVisionDesign read_design(const Json& value, const Source& where, SpectaclesSpec& spec) {
  SingleVisionDesign design;
  if (value.contains("base_curve_D")) design.base_curve_D = value["base_curve_D"].get<double>();
  design.center_thickness_m = metres_per_millimetre * value["center_thickness_mm"].get<double>();
  design.refractive_index = read_index(value, where, spec);
  design.vertex_distance_m = vertex_distance(value);
  design.diameter_m = diameter(value);
  design.mounting = read_mounting(value);
  return design;
}

/// What a prescription's text states beside the power becomes a member of the lens, unless that is there.
void move_to_lens(Json& value, const char* key, const std::optional<double>& stated, const Source& where) {
  if (!stated) return;
  const auto member = value.find(key);
  if (member != value.end() && *member != *stated)
    (where / key).fail(*member, Json(*stated).dump() + ", as the prescription's text has it, or nothing");
  value[key] = *stated;
}

/// The lens with the numbers of its prescription in place of a text in optical notation.
Json with_numbers(const std::string& maker, const Json& given, const Source& where, SpectaclesSpec& spec) {
  const auto text = given.find("prescription");
  if (text == given.end() || !text->is_string()) return given;
  Json value = given;
  const bool progressive = maker == "progressive";
  const auto stated = given.find("eye");
  const NotedPrescription rx =
      read_notation(text->get<std::string>(), where / "prescription",
                    stated == given.end() ? std::nullopt : eye_side(stated->get<std::string>()));
  value["prescription"] = prescription_object(rx, where / "prescription");
  value["prescription"].erase("vertex_distance_mm");
  move_to_lens(value, "vertex_distance_mm", rx.vertex_distance_mm, where);
  if (progressive) move_to_lens(value, "addition_D", rx.addition_D, where);
  if (progressive && rx.eye) value["eye"] = *rx.eye == EyeSide::right ? "right" : "left";
  if (!progressive && rx.addition_D)
    spec.notes.push_back(where.file + ": " + where.pointer + "/prescription is read as " + in_notation(rx) +
                         "; a single-vision lens has no addition");
  return value;
}

/// What the lens of a maker, "single_vision" or "progressive", is made from.
LensDesign read_maker(const std::string& maker, const Json& given, const Source& where, const Eye& eye,
                      SpectaclesSpec& spec) {
  const Json value = with_numbers(maker, given, where, spec);
  if (maker == "progressive" && !value.contains("addition_D"))
    missing(
        "addition_D", where,
        "\"addition_D\": a number from -10 to 10 (how much more power the front has in the near zone than in the far "
        "zone [D])");
  LensDesign design;
  design.lens = read_design(value, where, spec);
  design.power = lens_power(value, where, eye, design.lens.vertex_distance_m);
  if (maker == "progressive") design.progressive = read_progressive_design(value, where, design.lens);
  return design;
}

Spectacles made_lens(const LensDesign& design, const Source& where, SpectaclesSpec& spec) {
  spec.made_for = design.power;
  try {
    if (!design.progressive) return single_vision(design.power, design.lens);
    const ProgressiveLens made = progressive_lens(design.power, *design.progressive);
    spec.fits.push_back({"front", Eigen::Vector2d::Constant(made.knot_spacing_m), std::nullopt, made.power_residual});
    return made.lens;
  } catch (const std::logic_error& error) {  // std::invalid_argument, std::domain_error
    throw InputError(where.file, where.pointer, error.what(), "a lens that can be made");
  }
}

/// A lens out of a file of the trade.
Spectacles read_from_file(const Json& value, const Source& where, SpectaclesSpec& spec) {
  const auto length = [&](const char* key) {
    return value.contains(key) ? std::optional(metres_per_millimetre * value[key].get<double>()) : std::nullopt;
  };
  LensFileRequest request;
  request.file = existing_file(value["file"], where / "file", "the path of a .oma, .vca, .sdf or .zmx file").string();
  if (value.contains("eye")) request.eye = eye_side(value["eye"].get<std::string>());
  request.diameter_m = length("diameter_mm");
  request.center_thickness_m = length("center_thickness_mm");
  if (value.contains("refractive_index") || value.contains("material"))
    request.refractive_index = read_index(value, where, spec);
  LensFile made = read_lens_file(request);
  made.lens.vertex_distance_m = vertex_distance(value);
  made.lens.mounting = read_mounting(value);
  spec.input_files.push_back(request.file);
  spec.made_for = made.made_for;
  spec.fits = std::move(made.fits);
  spec.notes = std::move(made.notes);
  if (made.prism_cm_per_m == 0.0) return made.lens;
  try {
    return with_prism(made.lens, made.prism_cm_per_m, made.prism_base_deg);
  } catch (const std::domain_error& error) {
    throw InputError(request.file, "", error.what(), "a prism that the lens can have");
  }
}

/// The lens that `value` is, or names: a document, or a file of the trade as a document has it. Returns its place.
std::pair<Json, Source> lens_document(const Json& value, const Source& where) {
  if (!value.is_string()) return {value, where};
  const std::string name = value.get<std::string>();
  if (is_lens_file(name)) {
    existing_file(value, where, "the path of a lens file");
    return {Json{{"lens_file", {{"file", name}}}}, where};
  }
  return {load_named_document(value, where, "spectacles"),
          {named_document_file(value, where, "spectacles").string(), ""}};
}

}  // namespace

SpectaclesSpec read_spectacles(const Json& value, const Source& where, const Eye& eye) {
  SpectaclesSpec spec;
  if (value.is_null()) return spec;
  if (value.is_string()) {
    const auto [lens, place] = lens_document(value, where);
    spec = read_spectacles(lens, place, eye);
    if (place.file != where.file) spec.input_files.insert(spec.input_files.begin(), place.file);
    return spec;
  }
  std::string maker = "single_vision";
  for (const char* other : {"progressive", "lens_file"})
    if (value.contains(other)) maker = other;
  if (!value.contains(maker)) {
    spec.lens = read_two_surfaces(value, where, spec);
    return spec;
  }
  for (const auto& [key, member] : value.items())
    if (key != maker && key != "format" && key != "$schema")
      (where / key).fail(member, "no \"" + key + "\" beside \"" + maker + "\": it belongs inside");
  spec.lens = maker == "lens_file"
                  ? read_from_file(value[maker], where / maker, spec)
                  : made_lens(read_maker(maker, value[maker], where / maker, eye, spec), where / maker, spec);
  return spec;
}

std::optional<LensDesign> read_lens_design(const Json& value, const Source& where, const Eye& eye) {
  if (value.is_null()) return std::nullopt;
  const auto [lens, place] = lens_document(value, where);
  SpectaclesSpec spec;
  for (const char* maker : {"single_vision", "progressive"})
    if (lens.contains(maker)) return read_maker(maker, lens[maker], place / maker, eye, spec);
  return std::nullopt;
}

SpectaclesSpec read_lens_alone(const Json& value, const Source& where) {
  if (value.is_null()) where.fail(value, "a lens");
  const auto [lens, place] = lens_document(value, where);
  for (const char* maker : {"single_vision", "progressive"})
    if (const auto made = lens.find(maker); made != lens.end() && !made->contains("prescription"))
      missing("prescription", place / maker,
              "\"prescription\", as --rx states it, too: there is no eye here to take it from");
  return read_spectacles(value, where, Eye{});
}

}  // namespace sturm
