#include "io/specs/psf_spec.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/json/named_file.h"
#include "io/json/schema.h"
#include "io/specs/eye_spec.h"
#include "io/specs/wavefront_spec.h"
#include "io/specs/words.h"

namespace sturm {

namespace {

constexpr double usual_step_nm = 10.0;

/// The eye with the pupil and the Stiles–Crawford effect that the document has in place of its own.
void read_changed_eye(const Json& document, const Source& root, PsfSpec& spec) {
  const Json& given = document["eye"];
  Source where = root / "eye";
  Json eye = eye_object(given, where);
  if (given.is_string()) {
    where = {named_document_file(given, where, "eye").string(), ""};
    spec.input_files.push_back(where.file);
  }
  for (const char* key : {"pupil_diameter_mm", "stiles_crawford_per_mm2"})
    if (document.contains(key)) eye[key] = document[key];
  EyeSpec read = read_eye_spec(eye, where);
  spec.eye = read.eye;
  spec.notes = std::move(read.notes);
  if (!(spec.eye.pupil_radius_m > 0.0))
    (where / "pupil_diameter_mm").fail(eye["pupil_diameter_mm"], "a pupil > 0: a pinhole has no point spread");
  if (document.contains("in_focus_nm"))
    spec.in_focus_nm = document["in_focus_nm"].get<double>();
  else if (const auto stated = stated_wavelength_nm(eye, where))
    spec.in_focus_nm = *stated;
}

NamedLight read_line(double wavelength_nm) {
  return {formatted("%gnm", wavelength_nm), monochromatic_light(wavelength_nm)};
}

Light weighted_lines(const Json& value, const Source& where) {
  Light light;
  const Json& wavelengths = value["wavelengths_nm"];
  const bool given = value.contains("weights");
  if (given && value["weights"].size() != wavelengths.size())
    (where / "weights")
        .fail(value["weights"], std::to_string(wavelengths.size()) + " weights, one for each wavelength");
  double sum = 0.0;
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    const double nm = wavelengths[i].get<double>();
    light.push_back({nm, given ? value["weights"][i].get<double>() : luminous_efficiency(nm)});
    sum += light.back().weight;
  }
  if (!(sum > 0.0)) where.fail(value, "a light that is seen: weights whose sum is > 0");
  for (SpectralLine& line : light) line.weight /= sum;
  return light;
}

NamedLight read_light(const Json& value, const Source& where) {
  const int kinds = static_cast<int>(value.contains("wavelength_nm")) +
                    static_cast<int>(value.contains("wavelengths_nm")) + static_cast<int>(value.contains("spectrum"));
  if (kinds != 1) where.fail(value, "exactly one of \"wavelength_nm\", \"wavelengths_nm\" and \"spectrum\"");
  if (value.contains("weights") && !value.contains("wavelengths_nm"))
    (where / "weights").fail(value["weights"], "weights only for \"wavelengths_nm\"");
  if (value.contains("step_nm") && !value.contains("spectrum"))
    (where / "step_nm").fail(value["step_nm"], "a step only for a \"spectrum\"");
  NamedLight light;
  if (value.contains("wavelength_nm"))
    light = read_line(value["wavelength_nm"].get<double>());
  else if (value.contains("spectrum"))
    light = {"luminance", luminance_weighted_light(value.value("step_nm", usual_step_nm))};
  else
    light = {"wavelengths", weighted_lines(value, where)};
  light.id = value.value("id", light.id);
  return light;
}

void read_lights(const Json& document, const Source& root, PsfSpec& spec) {
  if (!document.contains("lights")) {
    if (std::find(spec.models.begin(), spec.models.end(), PsfModel::Waves) != spec.models.end())
      throw InputError(root.file, root.pointer, "no \"lights\"",
                       "\"lights\": the wavelengths of the waves, e.g. [{\"wavelength_nm\": 555}] or [{\"spectrum\": "
                       "\"luminance\"}]");
    spec.lights.push_back(read_line(spec.in_focus_nm));
    return;
  }
  std::set<std::string> ids;
  for (std::size_t i = 0; i < document["lights"].size(); ++i) {
    const Source where = root / "lights" / i;
    spec.lights.push_back(read_light(document["lights"][i], where));
    if (!ids.insert(spec.lights.back().id).second)
      where.fail(document["lights"][i], "an \"id\" that no other light has");
  }
}

void read_targets(const Json& document, const Source& root, PsfSpec& spec) {
  if (document.contains("defocus_D") && document.contains("distances_m"))
    (root / "defocus_D").fail(document["defocus_D"], "either \"defocus_D\" or \"distances_m\"");
  if (document.contains("distances_m")) {
    for (std::size_t i = 0; i < document["distances_m"].size(); ++i) {
      const double distance = read_distance(document["distances_m"][i], root / "distances_m" / i);
      const double vergence = 1.0 / distance, accommodation = spec.eye.accommodation_for(vergence);
      spec.targets.push_back({distance, accommodation, vergence - accommodation});
    }
    return;
  }
  if (!std::holds_alternative<RelaxedAccommodation>(spec.eye.accommodation))
    throw InputError(root.file, root.pointer, "an eye that accommodates",
                     "\"distances_m\", or a relaxed eye for \"defocus_D\"");
  if (!document.contains("defocus_D"))
    spec.targets.push_back({});
  else
    for (const Json& value : document["defocus_D"]) spec.targets.push_back({std::nullopt, 0.0, value.get<double>()});
}

}  // namespace

PsfSpec read_psf_spec(const Json& document, const std::string& file) {
  validate(document, "psf", file);
  const Source root{file, ""};
  const Json resolved = with_defaults(document, "psf");
  PsfSpec spec;
  spec.models = read_words(resolved["models"], root / "models", psf_model_words);
  read_changed_eye(document, root, spec);
  read_lights(document, root, spec);
  read_targets(document, root, spec);
  spec.examiner_frame = resolved["frame"] == "examiner";
  spec.frequencies_cpd = resolved["mtf"]["frequencies_cpd"].get<std::vector<double>>();
  spec.directions_deg = resolved["mtf"]["directions_deg"].get<std::vector<double>>();
  spec.energy_shares = resolved["energy_shares"].get<std::vector<double>>();
  spec.ray_count = resolved["rays"]["count"].get<std::size_t>();
  if (resolved["waves"].contains("grid")) spec.wave_grid = resolved["waves"]["grid"].get<int>();
  spec.cells_arcmin = resolved["comparison"]["cells_arcmin"].get<std::vector<double>>();
  spec.field_arcmin = resolved["comparison"]["field_arcmin"].get<double>();
  spec.pixel_arcmin = resolved["picture"]["pixel_arcmin"].get<double>();
  spec.size_px = resolved["picture"]["size_px"].get<int>() | 1;
  spec.resolved = std::make_shared<const Json>(resolved);
  return spec;
}

}  // namespace sturm
