#pragma once
#include <cstdint>
#include <vector>

namespace sturm {

/// Decides from one half of the samples which tiles go on; what it decides holds for the *other* half
/// (pathtrace/film/adaptive_render.h).
///
/// The relative MSE of the picture is the mean over tiles of σ²/n, σ² being n times a tile's measured squared error. It
/// reaches r² with the fewest samples where n = σ·⟨σ⟩/r² (Neyman 1934): a tile goes on until it has that many. A tile
/// that has stopped stays as it is.
class SamplePlanner {
 public:
  /// `tile_pixels`: how many pixels each tile has. `per_tile`: tiles stop one by one; otherwise all go on until the
  /// picture is good enough.
  SamplePlanner(std::vector<int> tile_pixels, double relative_error, bool per_tile);

  bool wants(std::size_t tile) const { return tiles_[tile].active; }
  double squared_error(std::size_t tile) const { return tiles_[tile].squared_error; }

  /// Relative squared error of an active tile with `samples` samples per pixel.
  void measured(std::size_t tile, std::uint32_t samples, double squared_error);

  /// To be called when all active tiles have been measured.
  void decide();

 private:
  struct Tile {
    double share;  ///< of the picture's pixels
    double squared_error = 0.0;
    std::uint32_t samples = 0;
    bool active = true;
  };

  std::vector<Tile> tiles_;
  double target_;
  bool per_tile_;
};

}  // namespace sturm
