#pragma once
#include <span>
#include <vector>

#include "wavefront/layers/kernel_model.h"

namespace sturm {

/// Vergences [D] of the planes that stand for those of a picture, ascending: the vergences themselves where they are
/// few, else uniform from the least to the largest, so close that from one to the next the edge of the pupil moves by
/// at most `spacing_px`. Throws std::invalid_argument for none, and for more than `most_planes`.
std::vector<double> planes_for(std::span<const double> vergences_D, double reach_px_per_D, double spacing_px = 1.0);

inline constexpr int few_planes = 16, most_planes = 1024;

/// The kernels of one eye on one picture: of every plane, part of the pupil and channel. Immutable.
class KernelBank {
 public:
  KernelBank(const KernelModel& model, std::vector<double> planes_D);

  const std::vector<double>& planes_D() const { return planes_D_; }  ///< ascending
  const std::vector<PupilPart>& parts() const { return parts_; }
  int channels() const { return channels_; }
  double reach_px_per_D() const { return reach_px_per_D_; }
  const KernelModel::PointKernel& point_kernel() const { return point_kernel_; }  ///< may be empty

  const std::vector<std::vector<PictureRay>>& rays() const { return rays_; }  ///< may be empty

  const SpreadKernel& kernel(int plane, int part, int channel) const {
    return kernels_[(static_cast<std::size_t>(plane) * parts_.size() + part) * channels_ + channel];
  }

  int radius_px(int plane) const { return radii_[plane]; }  ///< the largest of all parts and channels
  int largest_radius_px() const;

  /// The share, 0 … 1, of a surface's detail (layer_detail.h) that makes up for what a plane's kernels in a channel
  /// lose of it by sharing light out among pixels. None where the blur is so wide and even that it leaves nothing of
  /// detail.
  float detail_share(int plane, int channel) const {
    return detail_shares_[static_cast<std::size_t>(plane) * channels_ + channel];
  }

  /// The largest radius at a vergence between the planes.
  int radius_at(double vergence_D) const;

  /// Of a vergence: the plane before it, and the weight of the one behind that, 0 … 1.
  struct Place {
    int plane;
    float next_weight;
  };
  Place place_of(double vergence_D) const;

 private:
  std::vector<double> planes_D_;
  std::vector<PupilPart> parts_;
  int channels_;
  double reach_px_per_D_;
  KernelModel::PointKernel point_kernel_;
  std::vector<std::vector<PictureRay>> rays_;
  std::vector<SpreadKernel> kernels_;
  std::vector<int> radii_;
  std::vector<float> detail_shares_;  // of each plane and channel
  bool uniform_;
};

}  // namespace sturm
