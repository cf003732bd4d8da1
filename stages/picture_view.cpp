#include "stages/picture_view.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/camera_spec.h"
#include "io/specs/eye_spec.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr const char* attribute = "sturm";

/// The resolved document. Throws InputError for other documents.
Json document_of(const std::string& text) {
  Json document = parse_json(text, attribute);
  validate(document, "render", attribute);
  return document;
}

/// Why one formula does not give the blur of the whole picture; "" where it does.
std::string obstacle(const Json& document, const CameraSpec& camera) {
  if (camera.projection != Projection::Perspective || camera.gaze != Gaze::Camera || camera.interpupillary_distance_m)
    return "the view is not one eye in perspective and camera gaze";
  if (!document.value("spectacles", Json()).is_null()) return "the eye wears spectacles";
  return "";
}

void read_document(const Json& document, PictureView& view) {
  const CameraSpec camera = read_camera(document.at("camera"), {attribute, "/camera"});
  if (camera.projection == Projection::Equirectangular) {
    view.pixels_per_degree = camera.height / 180.0;
  } else {
    view.pixel_slope = 2.0 * std::tan(0.5 * camera.vfov) / camera.height;
    view.pixels_per_degree = radians_per_degree / *view.pixel_slope;
  }
  if (!view.layers.depth) return;
  view.missing_blur = obstacle(document, camera);
  if (!view.missing_blur.empty()) return;
  const Eye eye = read_eye(document.at("eye"), {attribute, "/eye"});
  view.layers.blur_px = blur_semi_axis_px(*view.layers.depth, eye, eye.accommodation_for(0.0), *view.pixel_slope);
}

}  // namespace

PictureView view_of(const LayeredImage& picture) {
  PictureView view;
  view.missing_blur = "no picture of this program with a depth layer";
  if (const auto depth = picture.layers.find("depth"); depth != picture.layers.end() && depth->second.channels == 1)
    view.layers.depth = depth->second;
  const auto text = picture.metadata.find(attribute);
  if (text == picture.metadata.end()) return view;
  try {
    read_document(document_of(text->second), view);
  } catch (const InputError&) {  // somebody else's attribute of that name, or another version's
  }
  return view;
}

PictureView view_of(const LayeredImage& first, const LayeredImage& second) {
  PictureView view = view_of(first), other = view_of(second);
  if (!view.pixels_per_degree) view.pixels_per_degree = other.pixels_per_degree;
  if (!view.pixel_slope) view.pixel_slope = other.pixel_slope;
  if (!view.layers.depth) view.layers.depth = std::move(other.layers.depth);
  if (!view.layers.blur_px) {
    view.layers.blur_px = std::move(other.layers.blur_px);
    view.missing_blur = other.missing_blur;
  }
  return view;
}

}  // namespace sturm
