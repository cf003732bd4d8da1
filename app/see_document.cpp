#include "app/see_document.h"

#include <nlohmann/json.hpp>

#include "app/configuration.h"
#include "app/eye_options.h"
#include "app/option_values.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/files/plain_file.h"
#include "io/json/values.h"
#include "io/specs/eye_spec.h"
#include "wavefront/layers/part_count.h"

namespace sturm {

namespace {

bool is_document(const std::string& picture) {
  return picture == "-" || has_suffix(picture, ".json");
}

/// A member that is an object, made where there is none.
Json& object_at(Json& document, const char* key) {
  Json& member = document[key];
  if (!member.is_object()) member = Json::object();
  return member;
}

/// Depth is given anew: what the document says of it counts no longer, but for what its numbers are.
void apply_depth(Json& document, const CommonOptions& common, const SeeOptions& options) {
  const std::string map = options.disparity_file.empty() ? options.depth : options.disparity_file;
  if (!options.distance_m.empty()) {
    if (!map.empty()) throw InputError("", "--distance-m", options.distance_m, "either a distance or a depth map");
    document["distance_m"] = distance_json(distance_option(options.distance_m, "--distance-m"));
    document.erase("depth");
    document.erase("stereo");
  }
  if (!map.empty()) {
    document.erase("distance_m");
    object_at(document, "depth")["file"] = path_in_document(common, map);
  }
  if (options.disparity) object_at(document, "depth")["unit"] = "disparity";
  if (!options.depth_unit.empty()) object_at(document, "depth")["unit"] = options.depth_unit;
  if (options.depth_scale) object_at(document, "depth")["scale"] = *options.depth_scale;
  if (options.focal_px) object_at(document, "stereo")["focal_px"] = *options.focal_px;
  if (options.baseline_m) object_at(document, "stereo")["baseline_m"] = *options.baseline_m;
  if (options.doffs_px) object_at(document, "stereo")["doffs_px"] = *options.doffs_px;
}

void apply_view(Json& document, const SeeOptions& options) {
  if (!options.vfov_deg && !options.hfov_deg) return;
  for (const char* key : {"vfov_deg", "hfov_deg", "pixel_slope"}) document.erase(key);
  if (options.vfov_deg) document["vfov_deg"] = *options.vfov_deg;
  if (options.hfov_deg) document["hfov_deg"] = *options.hfov_deg;
}

template <class T>
void set_if_given(Json& document, const char* key, const std::optional<T>& value) {
  if (value) document[key] = *value;
}

void apply_focus(Json& document, const CommonOptions& common, double focus_D) {
  document["eye"] = eye_object(document["eye"], {common.file, "/eye"});
  if (document["eye"].is_object()) document["eye"]["accommodation"] = {{"mode", "fixed"}, {"power_D", focus_D}};
}

int parts_of_error(double error) {
  if (const std::optional<int> parts = parts_for_error(error)) return *parts;
  const ErrorOfParts& most = errors_of_parts().back();
  throw InputError("", "--error", plain_number(error),
                   "at least " + plain_number(most.error) + ", which " + std::to_string(most.parts) +
                       " parts of the pupil reach, or --parts with more of them");
}

void apply_rest(Json& document, const SeeOptions& options) {
  if (!options.picture_layer.empty()) document["picture_layer"] = options.picture_layer;
  if (options.error)
    document["parts"] = parts_of_error(*options.error);
  else
    set_if_given(document, "parts", options.parts);
  if (!options.psf.empty()) document["psf"] = options.psf;
  if (options.chromatic) document["chromatic"] = true;
  set_if_given(document, "exposure", options.exposure);
  set_if_given(document, "png_bits", options.png_bits);
  if (!options.rack_focus_D.empty()) document["rack_focus_D"] = options.rack_focus_D;
  if (!options.pupil_sequence_mm.empty()) document["pupil_sequence_mm"] = options.pupil_sequence_mm;
  set_if_given(document, "frames", options.frames);
}

}  // namespace

CommonOptions with_see_source(const CommonOptions& common, const SeeOptions& options) {
  CommonOptions result = common;
  result.file = is_document(options.picture) ? options.picture : command_line_source;
  if (result.file == command_line_source && common.prescription.empty() && common.worn.eye.empty())
    throw InputError("", "--eye", "nothing", "the file of an eye, or --rx \"-2.00 -1.50 x 30\"");
  return result;
}

Json see_document(const CommonOptions& common, const SeeOptions& options) {
  Json document = load_configuration(
      common, {{"format", "sturm.see/1"}, {"picture", options.picture}, {"eye", {{"pupil_diameter_mm", 4}}}});
  if (!document.is_object()) return document;  // the reader says what is wrong
  apply_depth(document, common, options);
  apply_view(document, options);
  if (!options.layers.empty()) document["layers"] = Json::array();
  for (const std::string& layer : options.layers) document["layers"].push_back(path_in_document(common, layer));
  if (options.focus_D) apply_focus(document, common, *options.focus_D);
  apply_rest(document, options);
  return document;
}

}  // namespace sturm
