#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "io/json/json.h"
#include "io/specs/render_spec.h"

namespace sturm {

/// What a viewer's page is filled with (docs/formats/viewer_scene.md).
struct PageData {
  Json view;          ///< sturm.viewer_view/1
  std::string scene;  ///< sturm.viewer_scene/1
};

/// Reads the models and pictures of a view. `file` names the view in messages. Throws InputError for a projection that
/// the page does not have.
PageData page_data(const RenderSpec& spec, const std::string& file);

}  // namespace sturm
