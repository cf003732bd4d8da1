#include "pathtrace/cameras/ray_model.h"

#include <array>
#include <utility>

namespace sturm {

namespace {
constexpr std::array<std::pair<std::string_view, RayModel>, 6> names{{{"pinhole", RayModel::pinhole},
                                                                      {"thin_lens", RayModel::thin_lens},
                                                                      {"metalstigmatism", RayModel::metalstigmatism},
                                                                      {"sin2_radial", RayModel::sin2_radial},
                                                                      {"power_matrix", RayModel::power_matrix},
                                                                      {"zernike", RayModel::zernike}}};
}

std::optional<RayModel> ray_model_named(std::string_view name) {
  for (const auto& [text, model] : names)
    if (text == name) return model;
  return std::nullopt;
}

std::string name_of(RayModel model) {
  for (const auto& [text, candidate] : names)
    if (candidate == model) return std::string(text);
  return {};
}

}  // namespace sturm
