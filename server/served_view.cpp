#include "server/served_view.h"

#include <memory>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/images/image_formats.h"
#include "io/images/picture_file.h"
#include "io/json/data_uri.h"

namespace sturm {

namespace {

// A folder that is not there: in a sandbox, a document in it can name no file.
const std::string request_name = "<request>/view.json";

Json member(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) ? object[key] : Json(nullptr);
}

/// Spectacles that a view names as the server's document does are the server's: taken out here, put back by `restore`.
class OwnSpectacles {
 public:
  OwnSpectacles(Json& view, const ServedView& served) : served_(served) {
    right_ = take(view, served.document);
    if (view.contains("left") && view["left"].is_object() && served.document.contains("left"))
      left_ = take(view["left"], served.document["left"]);
  }

  void restore(RenderSpec& spec) const {
    Json resolved = *spec.resolved;
    if (right_) {
      spec.eye.spectacles = served_.spec.eye.spectacles;
      resolved["spectacles"] = served_.document["spectacles"];
    }
    if (left_ && spec.left && served_.spec.left) {
      spec.left->spectacles = served_.spec.left->spectacles;
      resolved["left"]["spectacles"] = served_.document["left"]["spectacles"];
    }
    spec.resolved = std::make_shared<const Json>(std::move(resolved));
  }

 private:
  static bool take(Json& object, const Json& own) {
    const Json given = member(object, "spectacles");
    if (!given.is_string() || given != member(own, "spectacles")) return false;
    object["spectacles"] = nullptr;
    return true;
  }

  const ServedView& served_;
  bool right_ = false, left_ = false;
};

void require_moderate(const RenderSpec& spec) {
  const Source where{request_name, ""};
  const double pixels = static_cast<double>(spec.camera.width) * spec.camera.height;
  if (pixels > most_asked_pixels)
    (where / "camera" / "resolution").fail(pixels, "at most " + std::to_string(int(most_asked_pixels)) + " pixels");
  if (static_cast<double>(spec.samples_per_pixel) > most_asked_samples)
    (where / "method" / "samples_per_pixel")
        .fail(spec.samples_per_pixel, "at most " + std::to_string(int(most_asked_samples)) + " samples");
}

std::optional<Image> read_page_picture(const Json& value, const CameraSpec& camera) {
  const Source where{"<request>", "/picture"};
  if (value.is_null()) return std::nullopt;
  const std::string expected = "a data URI of a PNG of " + std::to_string(camera.width) + " × " +
                               std::to_string(camera.height) + " pixels, or null";
  const auto bytes = value.is_string() ? data_of_uri(value.get_ref<const std::string&>(), where) : std::nullopt;
  if (!bytes) where.fail(value, expected);
  Image picture =
      read_embedded_image({reinterpret_cast<const unsigned char*>(bytes->data()), bytes->size()}, "<request>: /picture")
          .image;
  if (picture.channels == 4) picture = without_alpha(picture);
  if (picture.width != camera.width || picture.height != camera.height || picture.channels != 3)
    throw InputError(where.file, where.pointer,
                     std::to_string(picture.width) + " × " + std::to_string(picture.height) + " pixels", expected);
  return picture;
}

}  // namespace

RenderRequest read_render_request(const std::string& body, const ServedView& served) {
  const Json request = parse_json(body, "<request>");
  Json view = member(request, "view");
  if (!view.is_object()) Source{"<request>", "/view"}.fail(view, "a view (sturm.render/1)");
  const OwnSpectacles own(view, served);
  view["scene"] = Json::object();
  RenderRequest read;
  read.spec = read_render_spec(view, request_name);
  own.restore(read.spec);
  read.spec.scene = served.spec.scene;
  require_moderate(read.spec);
  read.page_picture = read_page_picture(member(request, "picture"), read.spec.camera);
  return read;
}

}  // namespace sturm
