#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "wavefront/layers/blur_plan.h"
#include "wavefront/layers/kernel_spectra.h"
#include "wavefront/layers/lamp_kernels.h"
#include "wavefront/layers/lamp_rays.h"
#include "wavefront/layers/layer_blur.h"
#include "wavefront/layers/layer_split.h"
#include "wavefront/layers/tile_light.h"

namespace sturm {

/// What all tiles of a picture share.
struct BlurScene {
  const LayeredPicture& picture;
  const KernelBank& bank;
  const BlurPlan& plan;
  const KernelSpectra& spectra;
  const LampKernels& lamps;
  float lamp_level;
};

/// Blurs tiles one after the other in memory of its own: one for each thread.
class TileBlur {
 public:
  explicit TileBlur(const BlurScene& scene);

  /// The tile whose kept part starts at the pixel (tile.left, tile.top), into `seen`; enters the work that was done.
  void blur(TileWork& tile, Image& seen);

  long long lamp_pixels() const { return lamp_pixels_; }  ///< of all tiles so far

 private:
  struct Lamp {
    int x, y;      // cell
    float rgb[3];  // its light beyond the lamp level, times its coverage
    std::uint16_t places = all_places;
  };

  struct Blurred {
    LayerWork work;
    bool covered;  // nothing behind it is seen
  };

  Blurred blur_layer(int plane, std::span<const LayerEntry> entries, std::span<const LampEntry> lamps);
  bool same_for_all_parts(std::span<const LayerEntry> entries) const;
  void fill_source(int plane, std::span<const LayerEntry> entries, int part, bool same, bool without_lamps);
  void take_lamps(std::span<const LampEntry> lamps);
  void light_in_place(const Lamp& lamp);
  void blur_source(BlurMethod method, int plane, int part, bool transformed);
  void add_lamps(int plane, int part);
  void add_lamp(const Lamp& lamp, const SpreadKernel& kernel, int channel, float share);
  void write(int left, int top, Image& seen) const;

  BlurScene scene_;
  SplitWindow window_;
  TileLight source_, spectrum_, blurred_;
  Image product_;
  KernelSpectra::Scratch kernel_spectra_;
  std::vector<TileLight> totals_;  // of each part of the pupil
  std::vector<Lamp> lamps_;
  CellBox lit_;
  LampRays lamp_rays_;
  long long lamp_pixels_ = 0;
};

}  // namespace sturm
