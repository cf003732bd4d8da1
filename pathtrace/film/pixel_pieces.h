#pragma once
#include <vector>

#include "io/images/fragment_image.h"

namespace sturm {

/// What one sample of a sharp view saw.
struct SeenSurface {
  Eigen::Vector3f point;  ///< [m]; of the surroundings the direction, unit length
  Eigen::Vector3f normal{0.0f, 0.0f, 0.0f};
  Eigen::Vector3f radiance{0.0f, 0.0f, 0.0f}, direct{0.0f, 0.0f, 0.0f}, albedo{0.0f, 0.0f, 0.0f};  ///< as of a Fragment
  Eigen::Vector2d place{0.5, 0.5};                                                                 ///< within the pixel
  float pixel_size = 0.0f;                                                                         ///< there [m]
  bool surroundings = false, emits = false, lambertian = false;
};

/// The pieces of one pixel of a sharp view, sample by sample.
class PixelPieces {
 public:
  void add(const SeenSurface& seen);

  /// A sample that counts for the size of its piece alone. False where there is no such piece yet.
  bool add_cover(const SeenSurface& seen);

  bool emits() const;

  /// True where a single piece has all samples, and it emits: its share is known without more of them.
  bool are_one_lamp() const;

  /// `samples`: all that were sent, also those that spectacles stopped.
  void append_to(std::vector<Fragment>& list, int samples) const;

 private:
  /// Sums over the samples of one piece of surface; its first sample says which plane it is.
  struct Piece {
    Eigen::Vector3f point, normal;
    float pixel_size;
    bool surroundings, emits, lambertian;
    Eigen::Vector3d position{0.0, 0.0, 0.0}, normals{0.0, 0.0, 0.0}, albedo{0.0, 0.0, 0.0};
    Eigen::Vector3d direct{0.0, 0.0, 0.0}, direct_squares{0.0, 0.0, 0.0}, indirect{0.0, 0.0, 0.0},
        indirect_squares{0.0, 0.0, 0.0};
    Eigen::Vector2d places{0.0, 0.0};
    Eigen::Matrix2d place_squares = Eigen::Matrix2d::Zero();
    int count = 0, cover = 0;  ///< samples that were shaded, samples that met it

    void cover_with(const SeenSurface& seen);
    Fragment fragment(int samples) const;
  };

  /// The piece that a sample belongs to; null where there is none yet and room for one.
  Piece* existing(const SeenSurface& seen);

  std::vector<Piece> pieces_;
};

}  // namespace sturm
