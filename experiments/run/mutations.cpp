#include "experiments/run/mutations.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "experiments/run/wrong_eyes.h"

namespace sturm {

namespace {

Prescription turned_axis(Prescription rx) {
  rx.axis_deg = folded_axis_deg(rx.axis_deg + 1.0);
  return rx;
}

Prescription mirrored_axis(Prescription rx) {
  rx.axis_deg = folded_axis_deg(180.0 - rx.axis_deg);
  return rx;
}

Prescription farther_lens(Prescription rx) {
  rx.vertex_distance_m += 1.5e-3;
  return rx;
}

const std::vector<Mutation>& all_mutations() {
  static const std::vector<Mutation> all = {
      {"semi_axis", "the larger semi-axis of the conoid's ellipses is 1 % too long", mutation::WrongSemiAxis{1.01}},
      {"turned_axis", "the conoid is given AXIS + 1°", mutation::WrongPrescription{turned_axis}},
      {"mirrored_axis", "the conoid is given AXIS 180° − α", mutation::WrongPrescription{mirrored_axis}},
      {"vertex_distance", "the conoid is given a vertex distance that is 1.5 mm too large (0.05 D at −6 D)",
       mutation::WrongPrescription{farther_lens}},
      {"tangential_term", "the path tracer's rays lack the tangential part of the slope",
       mutation::DroppedTangentialTerm{}},
      {"half_pixel", "path-traced spots and predicted pictures stand half a pixel too far to the right",
       mutation::HalfPixelShift{}},
      {"lost_light", "predicted pictures have lost 1 % of their light", mutation::LostLight{0.99}},
      {"mirrored_eye", "the point spreads are those of the other eye: x → −x", mutation::WrongEye{mirrored_eye}},
      {"point_reflected_psf", "the point spreads are turned round: p → −p in the pupil",
       mutation::WrongEye{point_reflected_eye}},
      {"noll_for_osa", "the coefficients' OSA numbers are read as Noll's", mutation::WrongEye{eye_read_as_noll}},
      {"pupil_scale", "the coefficients are taken for those of the pupil in use",
       mutation::WrongEye{eye_of_wrong_pupil}},
      {"stiles_crawford_left_out", "the point spreads take all of the pupil alike",
       mutation::WrongEye{eye_without_stiles_crawford}},
      {"gamma_left_in", "the point spreads blur sRGB values in place of light", mutation::BlurredAsEncoded{}},
  };
  return all;
}

Eye with_prescription(const Eye& eye, const mutation::WrongPrescription& wrong) {
  return Eye::with(wrong.read(eye.prescription), 2.0 * eye.pupil_radius_m, eye.accommodation);
}

template <class Change>
Replicates changed(const Replicates& pictures, const Change& change) {
  Replicates result;
  for (const Image& image : pictures.images) result.images.push_back(change(image));
  return result;
}

}  // namespace

std::vector<Mutation> mutations_named(std::span<const std::string> names) {
  std::vector<Mutation> chosen;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(all_mutations().begin(), all_mutations().end(), [&](const Mutation& m) { return m.id == name; });
    if (found == all_mutations().end())
      throw std::logic_error("the schema of experiments allows a mutation that is not known");
    chosen.push_back(*found);
  }
  return chosen;
}

std::optional<Footprint> mutated_footprint(const Mutation& mutation, const Eye& eye, const Footprint& honest) {
  if (const auto* wrong = std::get_if<mutation::WrongPrescription>(&mutation.kind))
    return naked_eye_footprint(with_prescription(eye, *wrong), honest.distance_m);
  if (const auto* wrong = std::get_if<mutation::WrongSemiAxis>(&mutation.kind)) {
    Footprint footprint = honest;
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(honest.angular, Eigen::ComputeFullU);
    const Eigen::Vector2d u = svd.matrixU().col(0);
    footprint.angular += (wrong->factor - 1.0) * u * (u.transpose() * honest.angular);
    return footprint;
  }
  return std::nullopt;
}

std::optional<Replicates> mutated_pictures(const Mutation& mutation, const Eye& eye,
                                           const PredictedReplicates& honest) {
  if (const auto* wrong = std::get_if<mutation::WrongPrescription>(&mutation.kind)) {
    const Eye other = with_prescription(eye, *wrong);
    Replicates pictures;
    for (const SharpView& view : honest.sharp_views)
      pictures.images.push_back(predict_image(view, other, other.accommodation_for(0.0)).radiance);
    return pictures;
  }
  if (std::holds_alternative<mutation::HalfPixelShift>(mutation.kind))
    return changed(honest.predictions, moved_half_pixel);
  if (const auto* lost = std::get_if<mutation::LostLight>(&mutation.kind))
    return changed(honest.predictions, [&](Image image) { return with_less_light(std::move(image), *lost); });
  return std::nullopt;
}

Image with_less_light(Image image, const mutation::LostLight& lost) {
  for (float& value : image.pixels) value *= static_cast<float>(lost.factor);
  return image;
}

Image moved_half_pixel(const Image& image) {
  constexpr std::array<float, 4> weights = {-1.0f / 16.0f, 9.0f / 16.0f, 9.0f / 16.0f, -1.0f / 16.0f};
  Image moved(image.width, image.height, image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int k = 0; k < 4; ++k) {
        const float* source = image.at(std::clamp(x + k - 2, 0, image.width - 1), y);
        for (int c = 0; c < image.channels; ++c) moved.at(x, y)[c] += weights[static_cast<std::size_t>(k)] * source[c];
      }
  return moved;
}

}  // namespace sturm
