#pragma once
#include <Eigen/Core>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "conoid/tracing/footprint.h"
#include "experiments/run/replicates.h"
#include "io/json/json.h"

namespace sturm {

/// What a mutation makes wrong. Each is put into one predictor alone; the other one, and everything that was measured
/// of it, stays.
namespace mutation {

/// The conoid reads another prescription than the path tracer.
struct WrongPrescription {
  Prescription (*read)(Prescription);
};

/// The larger semi-axis of the conoid's ellipses, times `factor`. (No eye has such ellipses at all distances: predicted
/// pictures, which are made from an eye, stay as they are.)
struct WrongSemiAxis {
  double factor;
};

/// The path tracer's eye bends each ray within its own meridian only: `sin2_radial` rays pass for `power_matrix`.
struct DroppedTangentialTerm {};

/// Half a pixel to the right: the path-traced spots, and the predicted pictures.
struct HalfPixelShift {};

/// The predicted pictures' radiance, times `factor`.
struct LostLight {
  double factor;
};

/// Point spreads over depth are those of another eye, which the measured one is taken for.
struct WrongEye {
  Eye (*read)(const Eye&);
};

/// Point spreads over depth blur sRGB values in place of light.
struct BlurredAsEncoded {};

}  // namespace mutation

using MutationKind =
    std::variant<mutation::WrongPrescription, mutation::WrongSemiAxis, mutation::DroppedTangentialTerm,
                 mutation::HalfPixelShift, mutation::LostLight, mutation::WrongEye, mutation::BlurredAsEncoded>;

struct Mutation {
  std::string id, what;
  MutationKind kind;
};

/// An error that a section tries on itself in every run, whatever the experiment asks for.
struct OwnMutation {
  const char* id;
  const char* what;
};

/// The mutations of these names (`mutations` of configs/schemas/experiment.schema.json), in the order given.
std::vector<Mutation> mutations_named(std::span<const std::string> names);

/// What the mutated conoid says of an eye at `honest.distance_m`; null where the mutation is none of its ellipses.
std::optional<Footprint> mutated_footprint(const Mutation& mutation, const Eye& eye, const Footprint& honest);

/// Predicted pictures of the mutated predictor, from the sharp views of the honest one; none where the mutation is none
/// of predicted pictures.
std::optional<Replicates> mutated_pictures(const Mutation& mutation, const Eye& eye, const PredictedReplicates& honest);

/// A picture moved to the right by half a pixel: (−1, 9, 9, −1)/16 of the four neighbours, whose mean is half a pixel
/// away and whose variance is zero, so that nothing is blurred to second order. Columns beyond the border repeat it.
Image moved_half_pixel(const Image& image);

Image with_less_light(Image image, const mutation::LostLight& lost);

}  // namespace sturm
