#pragma once
#include <optional>
#include <string>

#include "io/images/image.h"
#include "io/json/json.h"
#include "io/specs/render_spec.h"

namespace sturm {

/// The view that a server was started with, which its page shows. Its files are the user's own.
struct ServedView {
  Json document;  ///< sturm.render/1
  RenderSpec spec;
};

/// What a page asks to be rendered.
struct RenderRequest {
  RenderSpec spec;
  std::optional<Image> page_picture;  ///< what the page shows of it, for a display; 3 channels, of the camera's size
};

/// Largest picture [px], and most samples of a pixel, that a page may ask for.
inline constexpr double most_asked_pixels = 4e6;
inline constexpr double most_asked_samples = 4096;

/// Reads {"view": sturm.render/1, "picture": "data:image/png;base64,…" or null}. Eye, spectacles, camera, method and
/// seed are those of the view; the scene is the server's whatever the view says, and so are spectacles that the view
/// names as the server's document does. Nothing of the request may name a file: whoever reaches the server is not
/// trusted with files (enter_sandbox must have been called). Throws InputError.
RenderRequest read_render_request(const std::string& body, const ServedView& served);

}  // namespace sturm
