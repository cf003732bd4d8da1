#include "io/specs/see_spec.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/json/named_file.h"
#include "io/json/schema.h"
#include "io/specs/eye_spec.h"
#include "io/specs/wavefront_spec.h"
#include "io/specs/words.h"
#include "lensmodel/chromatic_eye.h"

namespace sturm {

namespace {

constexpr int usual_frames = 25;

std::string file_at(const Json& value, const Source& where, const char* what, SeeSpec& spec) {
  spec.input_files.push_back(existing_file(value, where, what).string());
  return spec.input_files.back();
}

/// Without "by_file", which is none of them.
constexpr Words<DepthUnit, 4> depth_unit_words{{{DepthUnit::Metres, "m"},
                                                {DepthUnit::Millimetres, "mm"},
                                                {DepthUnit::Dioptres, "D"},
                                                {DepthUnit::Disparity, "disparity"}}};

void read_depth(const Json& document, const Source& root, SeeSpec& spec) {
  if (document.contains("distance_m")) {
    if (document.contains("depth"))
      (root / "distance_m").fail(document["distance_m"], "either a distance or a depth map");
    spec.distance_m = read_distance(document["distance_m"], root / "distance_m");
  }
  const Json depth = document.value("depth", Json::object());
  if (depth.contains("file")) spec.depth_map = file_at(depth["file"], root / "depth" / "file", "a depth map", spec);
  spec.depth_reading.unit = depth_unit_words.value_of(depth.value("unit", ""));
  if (depth.contains("scale")) spec.depth_reading.scale = depth["scale"].get<double>();
  const bool disparity = spec.depth_reading.unit == DepthUnit::Disparity;
  if (disparity != document.contains("stereo"))
    throw InputError(root.file, root.pointer, disparity ? "disparities without a calibration" : "\"stereo\"",
                     "\"stereo\", the calibration of the cameras, beside a depth of unit \"disparity\", and nowhere "
                     "else");
  if (disparity) {
    const Json& stereo = document["stereo"];
    spec.depth_reading.stereo = {stereo["focal_px"].get<double>(), stereo["baseline_m"].get<double>(),
                                 stereo["doffs_px"].get<double>()};
  }
}

/// Throws unless at most one of the three tells how wide the view is.
void read_view(const Json& document, const Source& root, SeeSpec& spec) {
  int given = 0;
  const auto read = [&](const char* key, std::optional<double>& value) {
    if (!document.contains(key)) return;
    value = document[key].get<double>();
    if (++given > 1) (root / key).fail(document[key], "one of \"vfov_deg\", \"hfov_deg\" and \"pixel_slope\"");
  };
  read("vfov_deg", spec.vfov_deg);
  read("hfov_deg", spec.hfov_deg);
  read("pixel_slope", spec.pixel_slope);
}

/// The eye's document in frame `i` of `count`.
Json eye_of_frame(const Json& document, Json eye, int i, int count) {
  const auto between = [&](const Json& ends) {
    return std::lerp(ends[0].get<double>(), ends[1].get<double>(), static_cast<double>(i) / (count - 1));
  };
  if (document.contains("rack_focus_D"))
    eye["accommodation"] = {{"mode", "fixed"}, {"power_D", between(document["rack_focus_D"])}};
  if (document.contains("pupil_sequence_mm")) eye["pupil_diameter_mm"] = between(document["pupil_sequence_mm"]);
  return eye;
}

/// Pictures take a wave as it is, whatever light it is stated for.
void note_wavelength(const Json& eye, const Source& where, SeeSpec& spec) {
  const std::optional<double> stated = stated_wavelength_nm(eye, where);
  if (!stated || *stated == focus_wavelength_nm) return;
  spec.notes.push_back(where.file + ": " + where.pointer + "/wavefront/wavelength_nm is " + plain_number(*stated) +
                       ": the picture takes the wave as it is. In " + plain_number(focus_wavelength_nm) +
                       " nm the eye's refraction is " +
                       formatted("%+.2f", chromatic_vergence_D(focus_wavelength_nm, *stated)) + " D from there");
}

/// An eye that accommodates as well as it can needs one distance to do so for.
SeeingEye seeing_eye(const Json& eye, const Source& where, SeeSpec& spec) {
  validate(eye, "eye", where);
  EyeSpec read = read_eye_spec(eye, where);
  if (spec.frames.empty()) {
    spec.notes = std::move(read.notes);
    note_wavelength(eye, where, spec);
  }
  if (!spec.distance_m) require_camera_accommodation(read.eye.accommodation, std::nullopt, where / "accommodation");
  return {read.eye, read.eye.accommodation_for(spec.distance_m ? 1.0 / *spec.distance_m : 0.0)};
}

/// Reads the eye of each frame; the first one's becomes the one of the document.
void read_frames(Json& document, const Source& root, SeeSpec& spec) {
  Source where = root / "eye";
  const Json eye = eye_object(document["eye"], where);
  if (document["eye"].is_string()) {
    where = {named_document_file(document["eye"], where, "eye").string(), ""};
    spec.input_files.push_back(where.file);
  }
  spec.sequence = document.contains("rack_focus_D") || document.contains("pupil_sequence_mm");
  if (!spec.sequence && document.contains("frames"))
    (root / "frames").fail(document["frames"], "no number of frames without \"rack_focus_D\" or \"pupil_sequence_mm\"");
  const int count = spec.sequence ? document.value("frames", usual_frames) : 1;
  if (spec.sequence) document["frames"] = count;
  for (int i = 0; i < count; ++i) {
    const Json changed = eye_of_frame(document, eye, i, count);
    spec.frames.push_back(seeing_eye(changed, where, spec));
    if (i == 0) document["eye"] = with_defaults(changed, "eye");
  }
}

}  // namespace

SeeSpec read_see_spec(const Json& given, const std::string& file) {
  validate(given, "see", file);
  const Source root{file, ""};
  Json document = given;
  if (!document.contains("distance_m")) document.emplace("depth", Json::object());
  document = with_defaults(document, "see");
  SeeSpec spec;
  spec.picture = file_at(document["picture"], root / "picture", "a picture", spec);
  if (document.contains("picture_layer")) spec.picture_layer = document["picture_layer"].get<std::string>();
  for (std::size_t i = 0; i < document["layers"].size(); ++i)
    spec.layers.push_back(file_at(document["layers"][i], root / "layers" / i, "a layer's picture", spec));
  read_depth(document, root, spec);
  read_view(document, root, spec);
  read_frames(document, root, spec);
  spec.psf = read_word(document["psf"], root / "psf", seen_psf_words);
  spec.parts = document["parts"].get<int>();
  spec.chromatic = document["chromatic"].get<bool>();
  spec.exposure = document["exposure"].get<double>();
  spec.png_bits = document["png_bits"].get<int>();
  spec.resolved = std::make_shared<const Json>(std::move(document));
  return spec;
}

}  // namespace sturm
