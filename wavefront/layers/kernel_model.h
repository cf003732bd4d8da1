#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "wavefront/psf/spread_kernel.h"

namespace sturm {

/// A part of the pupil as the blur of a picture needs it.
struct PupilPart {
  double weight = 1.0;                                       ///< its share of the pupil's light; all of them make 1
  Eigen::Vector2d shift_px_per_D = Eigen::Vector2d::Zero();  ///< by which its picture of a point moves with the
                                                             ///< point's vergence: to the right, down
};

/// A ray through a point of the pupil on the pixels of a picture.
struct PictureRay {
  Eigen::Vector2f at_0_D, per_D;  ///< where the ray of a target at 0 D lands, from the target's own place [px, to the
                                  ///< right and down], and how that changes with its vergence
  float weight;                   ///< share of the light

  Eigen::Vector2f landing(float vergence_D) const { return at_0_D + vergence_D * per_D; }
};

/// Where the kernels of an eye come from: rays or waves, on the pixels of one picture.
struct KernelModel {
  std::vector<PupilPart> parts;  ///< at least one
  int channels = 1;              ///< 1: the same kernels for all colours; 3: kernels for R, G and B
  double reach_px_per_D = 0.0;   ///< by which the edge of the pupil moves the picture of a point with its vergence
  /// The picture of a point at a vergence [D] through one part in one channel; it sums to 1.
  std::function<SpreadKernel(double vergence_D, int part, int channel)> kernel;
  /// The same of a point beside the middle of its pixel [px, to the right and down], without the pixel's own width. May
  /// be empty.
  using PointKernel =
      std::function<SpreadKernel(double vergence_D, int part, int channel, const Eigen::Vector2d& from)>;
  PointKernel point_kernel = {};
  /// Of each channel: rays of all parts in turn, so that the first ones are spread over the pupil. May be empty.
  std::vector<std::vector<PictureRay>> rays = {};
};

}  // namespace sturm
