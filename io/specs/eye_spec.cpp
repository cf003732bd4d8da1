#include "io/specs/eye_spec.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/files/error.h"
#include "io/json/named_file.h"
#include "io/json/schema.h"
#include "io/specs/wavefront_spec.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double largest_human_pupil_mm = 10.0;

/// Throws unless exactly one of two members is there.
void require_one_of(const Json& value, const char* a, const char* b, const Source& where) {
  const std::string expected = "exactly one of \"" + std::string(a) + "\" and \"" + b + "\" for mode \"" +
                               value["mode"].get<std::string>() + "\"";
  if (value.contains(a) == value.contains(b)) where.fail(value, expected);
}

void require_absent(const Json& value, std::initializer_list<const char*> keys, const Source& where) {
  for (const char* key : keys)
    if (value.contains(key))
      (where / key)
          .fail(value[key], "no \"" + std::string(key) + "\" for mode \"" + value["mode"].get<std::string>() + "\"");
}

/// An eye with a measured wavefront; `rx` is its prescription, if it has one too.
Eye read_wavefront_eye(const Json& value, const Source& where, const std::optional<Prescription>& rx, double pupil_mm,
                       const Accommodation& accommodation) {
  if (rx.has_value() != value["combine"].get<bool>())
    where.fail(value, rx ? "\"combine\": true where there is a prescription too" : "a prescription for \"combine\"");
  const double wave_pupil_mm = value["pupil_diameter_mm"].get<double>();
  if (pupil_mm > wave_pupil_mm)
    (where / "pupil_diameter_mm")
        .fail(value["pupil_diameter_mm"], "at least the eye's own " + Json(pupil_mm).dump() + " mm");
  const WavefrontSpec measured = read_wavefront(value, where);
  return Eye::with(measured.wave, measured.second_order, rx, metres_per_millimetre * pupil_mm, accommodation);
}

/// Which eye a wavefront was measured of, if that is said.
std::optional<EyeSide> measured_side(const Json& eye) {
  const Json wavefront = eye.value("wavefront", Json::object());
  return wavefront.contains("eye") ? eye_side(wavefront["eye"].get<std::string>()) : std::nullopt;
}

Prescription read_eyes_prescription(const Json& value, const Source& where, std::optional<EyeSide> side,
                                    EyeSpec& spec) {
  if (value.is_string())
    if (const NotedPrescription noted = read_notation(value.get<std::string>(), where, side); noted.addition_D)
      spec.notes.push_back(where.file + ": " + where.pointer + " is read as " + in_notation(noted) +
                           "; its addition is for near glasses and changes nothing here");
  return read_prescription(value, where, side);
}

}  // namespace

double read_distance(const Json& value, const Source& where) {
  if (value.is_string() && value == "inf") return std::numeric_limits<double>::infinity();
  if (!value.is_number() || !(value.get<double>() > 0.0)) where.fail(value, "a number > 0 or \"inf\" (distance [m])");
  return value.get<double>();
}

Prescription read_prescription(const Json& given, const Source& where, std::optional<EyeSide> eye) {
  const Json object =
      given.is_string() ? prescription_object(read_notation(given.get<std::string>(), where, eye), where) : given;
  const Json value = with_defaults(object, "eye", "prescription");
  Prescription rx;
  rx.sphere_D = value.at("sphere_D").get<double>();
  rx.cylinder_D = value.at("cylinder_D").get<double>();
  if (rx.cylinder_D != 0.0 && !value.contains("axis_deg"))
    throw InputError(where.file, where.pointer, "no \"axis_deg\"", "the AXIS of the cylinder [deg], from 0 to 180");
  rx.axis_deg = value.value("axis_deg", rx.axis_deg);
  rx.vertex_distance_m = metres_per_millimetre * value.at("vertex_distance_mm").get<double>();
  rx.prism_cm_per_m = value.at("prism_cm_per_m").get<double>();
  rx.prism_base_deg = value.value("prism_base_deg", 0.0);
  if (rx.prism_cm_per_m != 0.0 && !value.contains("prism_base_deg"))
    throw InputError(where.file, where.pointer, "no \"prism_base_deg\"", "the base of the prism [deg], from 0 to 360");
  try {
    validate(rx);
    power_at_cornea(rx);
  } catch (const std::domain_error&) {
    where.fail(given, "a vertex distance that is not a focal length of the lens");
  } catch (const std::invalid_argument& error) {
    where.fail(given, error.what());
  }
  return rx;
}

Accommodation read_accommodation(const Json& value, const Source& where) {
  const std::string mode = value.at("mode").get<std::string>();
  if (mode == "relaxed") {
    require_absent(value, {"focus_distance_m", "power_D", "amplitude_D", "age_years"}, where);
    return RelaxedAccommodation{};
  }
  if (mode == "fixed") {
    require_absent(value, {"amplitude_D", "age_years"}, where);
    require_one_of(value, "focus_distance_m", "power_D", where);
    if (value.contains("power_D")) return FixedAccommodation{value["power_D"].get<double>(), 0.0};
    const double distance_m = read_distance(value["focus_distance_m"], where / "focus_distance_m");
    return FixedAccommodation{1.0 / distance_m, distance_m};
  }
  require_absent(value, {"focus_distance_m", "power_D"}, where);
  require_one_of(value, "amplitude_D", "age_years", where);
  if (value.contains("amplitude_D")) return BestAccommodation{value["amplitude_D"].get<double>()};
  return BestAccommodation{hofstetter_amplitude(value["age_years"].get<double>())};
}

Eye make_eye(const Prescription& rx, double pupil_diameter_m, const Accommodation& accommodation, const Source& where) {
  try {
    return Eye::with(rx, pupil_diameter_m, accommodation);
  } catch (const std::logic_error& error) {  // std::invalid_argument, std::domain_error
    throw InputError(where.file, where.pointer, error.what(), "an eye that can be computed");
  }
}

void require_rays(RayModel ray_model, const Accommodation& accommodation, const Source& where) {
  if (!has_rays(ray_model, accommodation))
    throw InputError(where.file, where.pointer, "no \"focus_distance_m\"",
                     "mode \"fixed\" with a \"focus_distance_m\", which ray model " + name_of(ray_model) + " needs");
}

void require_camera_accommodation(const Accommodation& accommodation, std::optional<RayModel> ray_model,
                                  const Source& where) {
  if (std::holds_alternative<BestAccommodation>(accommodation))
    throw InputError(where.file, where.pointer, "mode \"best\"",
                     "\"relaxed\" or \"fixed\": in camera gaze one accommodation holds for all distances");
  if (ray_model) require_rays(*ray_model, accommodation, where);
}

Json eye_object(const Json& value, const Source& where) {
  return value.is_string() ? load_named_document(value, where, "eye") : value;
}

EyeSpec read_eye_spec(const Json& value, const Source& where) {
  EyeSpec spec;
  const Json written = eye_object(value, where), object = with_defaults(written, "eye");
  Source place = where;
  if (value.is_string()) {
    place = {named_document_file(value, where, "eye").string(), ""};
    spec.input_files.push_back(place.file);
  }
  if (!object.contains("prescription") && !object.contains("wavefront"))
    throw InputError(place.file, place.pointer, "no \"prescription\"", "a \"prescription\" or a \"wavefront\"");
  std::optional<Prescription> rx;
  if (object.contains("prescription"))
    rx = read_eyes_prescription(written["prescription"], place / "prescription", measured_side(object), spec);
  const Accommodation accommodation = read_accommodation(object["accommodation"], place / "accommodation");
  const double pupil_mm = object.at("pupil_diameter_mm").get<double>();
  spec.eye = object.contains("wavefront")
                 ? read_wavefront_eye(object["wavefront"], place / "wavefront", rx, pupil_mm, accommodation)
                 : make_eye(*rx, metres_per_millimetre * pupil_mm, accommodation, place);
  spec.eye.rotation_center_m = metres_per_millimetre * object["rotation_center_mm"].get<double>();
  spec.eye.stiles_crawford_per_m2 =
      object["stiles_crawford_per_mm2"].get<double>() / (metres_per_millimetre * metres_per_millimetre);
  if (pupil_mm > largest_human_pupil_mm)
    spec.notes.push_back(place.file + ": " + place.pointer + "/pupil_diameter_mm is " +
                         object["pupil_diameter_mm"].dump() + " mm, more than a human pupil's 10 mm");
  return spec;
}

Eye read_eye(const Json& value, const Source& where) {
  return read_eye_spec(value, where).eye;
}

}  // namespace sturm
