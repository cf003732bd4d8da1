#pragma once
#include <cstdint>

#include "pathtrace/cameras/camera_concept.h"
#include "pathtrace/sampling/sequence.h"
#include "pathtrace/sampling/vector_math.h"

namespace sturm {

/// The random numbers that the vertices of plain paths take, for the samples of one block of camera rays. Where the
/// first path of the block comes to a depth, the numbers of that depth are made for all of them: the loop over the
/// samples vectorises, so that the block costs little more than one sample. The same bits as from the sequence itself.
class VertexNumbers {
 public:
  struct Vertex {
    float light_u, light_v;  ///< uniform in [0, 1)
    LocalDirection scatter;  ///< with density cos θ / π
  };

  /// `sequence` must outlive the object.
  explicit VertexNumbers(const PixelSequence& sequence) : sequence_(sequence) {}

  /// From now on the block's samples are first_sample … first_sample + count − 1; count ≤ CameraRayBlock::size.
  void begin_block(std::uint32_t first_sample, int count = CameraRayBlock::size) {
    first_sample_ = first_sample;
    count_ = count;
    known_ = 0;
  }

  const PixelSequence& sequence() const { return sequence_; }

  /// Of the vertex after `bounce` bounces of a sample of the block.
  Vertex vertex(std::uint32_t sample, int bounce) {
    if (!in_table(bounce)) return single_vertex(sample, bounce);
    const Depth& d = depths_[bounce];
    const std::uint32_t i = sample - first_sample_;
    return {d.light_u[i], d.light_v[i], {d.x[i], d.y[i], d.z[i]}};
  }

  /// That vertex's uniform number in [0, 1) for Russian roulette.
  float survive(std::uint32_t sample, int bounce) {
    if (!in_table(bounce)) return unit_float(sequence_.single(sample, first_dimension(bounce) + dimension::survive));
    return depths_[bounce].survive[sample - first_sample_];
  }

 private:
  static constexpr int depths = 10, size = CameraRayBlock::size;
  struct Depth {
    alignas(64) float light_u[size], light_v[size], x[size], y[size], z[size], survive[size];
  };

  static std::uint32_t first_dimension(int bounce) {
    return dimension::first_vertex + dimension::per_vertex * static_cast<std::uint32_t>(bounce);
  }
  /// Whether the table has numbers of this depth. Other sequences do not vectorise, and few paths come deep.
  bool in_table(int bounce) {
    if (bounce >= depths || sequence_.kind() != Sequence::Sobol) return false;
    for (; known_ <= bounce; ++known_) fill(known_);
    return true;
  }
  Vertex single_vertex(std::uint32_t sample, int bounce) const;
  void fill(int bounce);
  /// A number of lanes that the compiler knows: a block that is not half full costs half.
  template <int lanes>
  void fill_lanes(int bounce);

  const PixelSequence& sequence_;
  std::uint32_t first_sample_ = 0;
  int count_ = size, known_ = 0;
  Depth depths_[depths];
};

}  // namespace sturm
