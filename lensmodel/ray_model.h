#pragma once
#include <string>

#include "lensmodel/accommodation.h"
#include "lensmodel/words.h"

namespace sturm {

/// How the eye bends the ray that leaves it through a pupil point (docs/theory.md#5-ray-models). An eye without a
/// measured wavefront has, for zernike, that of its prescription.
enum class RayModel { pinhole, thin_lens, metalstigmatism, sin2_radial, power_matrix, zernike };

inline constexpr Words<RayModel, 6> ray_model_words{{{RayModel::pinhole, "pinhole"},
                                                     {RayModel::thin_lens, "thin_lens"},
                                                     {RayModel::metalstigmatism, "metalstigmatism"},
                                                     {RayModel::sin2_radial, "sin2_radial"},
                                                     {RayModel::power_matrix, "power_matrix"},
                                                     {RayModel::zernike, "zernike"}}};  ///< in documents

/// The word for it in documents.
inline std::string name_of(RayModel model) {
  return std::string(ray_model_words.word_of(model));
}

inline std::optional<RayModel> ray_model_named(std::string_view name) {
  return ray_model_words.value_of(name);
}  ///< none where no model has this word

/// False where the model has no rays for an eye in this state: metalstigmatism adds the eye's focal distance to that of
/// a target and needs one that is stated.
inline bool has_rays(RayModel model, const Accommodation& accommodation) {
  return model != RayModel::metalstigmatism || stated_focus_distance_m(accommodation).has_value();
}

}  // namespace sturm
