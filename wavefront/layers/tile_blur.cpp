#include "wavefront/layers/tile_blur.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "wavefront/fft/tile_transform.h"
#include "wavefront/layers/brightness.h"
#include "wavefront/layers/part_composite.h"

namespace sturm {

namespace {

constexpr float flat = 1e-4f;  // change of a surface's size on the picture that counts as none

/// How much larger the picture of a pixel of a slanted surface is through a part of the pupil: 1 + c·∇V.
float stretch(const LayerEntry& entry, const PupilPart& part) {
  return 1.0f + entry.slope_x * static_cast<float>(part.shift_px_per_D.x()) +
         entry.slope_y * static_cast<float>(part.shift_px_per_D.y());
}

}  // namespace

TileBlur::TileBlur(const BlurScene& scene)
    : scene_(scene),
      window_(scene.picture, scene.bank),
      source_(scene.plan.side(), scene.bank.channels()),
      spectrum_(source_),
      blurred_(source_),
      product_(source_.planes[0]),
      totals_(scene.bank.parts().size(), source_),
      lamp_rays_(scene.picture, scene.bank, scene.plan) {}

void TileBlur::blur(TileWork& tile, Image& seen) {
  const int rim = scene_.plan.rim(), side = scene_.plan.side();
  window_.split({tile.left - rim, tile.top - rim, side});
  for (TileLight& total : totals_) total.clear();
  lamp_rays_.follow(window_);
  lamp_pixels_ += lamp_rays_.lamps();
  tile.layers.clear();
  bool covered = false;
  for (int plane = static_cast<int>(scene_.bank.planes_D().size()) - 1; plane >= 0; --plane) {
    const auto entries = window_.entries_of(plane);
    if (entries.empty() || covered) {
      tile.layers.push_back(entries.empty() ? LayerWork::Empty : LayerWork::Covered);
      continue;
    }
    const Blurred layer = blur_layer(plane, entries, window_.lamps_of(plane));
    tile.layers.push_back(layer.work);
    covered = layer.covered;
  }
  write(tile.left, tile.top, seen);
}

TileBlur::Blurred TileBlur::blur_layer(int plane, std::span<const LayerEntry> entries,
                                       std::span<const LampEntry> lamps) {
  const int parts = static_cast<int>(totals_.size());
  lit_ = box_of(entries, scene_.plan.side());
  const bool same = same_for_all_parts(entries);
  const BlurMethod method = scene_.plan.method(plane, lit_, source_.count(), same);
  const CellBox kept = scene_.plan.kept();
  bool covered = true;
  for (int part = 0; part < parts; ++part) {
    const bool fresh = part == 0 || !same;
    if (fresh) {
      fill_source(plane, entries, part, same, method == BlurMethod::Transform);
      take_lamps(lamps);
    }
    if (method == BlurMethod::Unblurred) {
      if (fresh)
        for (const Lamp& lamp : lamps_) light_in_place(lamp);
      covered &= lay_behind(source_, kept, totals_[part]);
      continue;
    }
    blur_source(method, plane, part, !fresh);
    if (method == BlurMethod::Transform) clear_rounding(kept, blurred_);
    add_lamps(plane, part);
    covered &= lay_behind(blurred_, kept, totals_[part]);
  }
  return {method == BlurMethod::Unblurred ? LayerWork::Unblurred
          : method == BlurMethod::Spatial ? LayerWork::Spatial
                                          : LayerWork::Transform,
          covered};
}

bool TileBlur::same_for_all_parts(std::span<const LayerEntry> entries) const {
  if (totals_.size() == 1) return true;
  float slant = 0.0f, shift = 0.0f;
  for (const LayerEntry& entry : entries) slant = std::max({slant, std::abs(entry.slope_x), std::abs(entry.slope_y)});
  for (const PupilPart& part : scene_.bank.parts())
    shift = std::max(shift, static_cast<float>(part.shift_px_per_D.lpNorm<1>()));
  return slant * shift < flat;
}

void TileBlur::fill_source(int plane, std::span<const LayerEntry> entries, int part, bool same, bool without_lamps) {
  source_.clear();
  lamps_.clear();
  const int side = source_.side();
  float detail_shares[3];
  for (int c = 0; c < 3; ++c) detail_shares[c] = scene_.bank.detail_share(plane, source_.kernel_of(c));
  float* planes[6];
  for (int i = 0; i < source_.count(); ++i) planes[i] = source_.planes[i].pixels.data();
  for (const LayerEntry& entry : entries) {
    const float weight = same ? entry.weight : entry.weight * std::max(0.0f, stretch(entry, scene_.bank.parts()[part]));
    const float brightness = brightness_of(entry.rgb);
    float kept = weight;
    if (without_lamps && brightness > scene_.lamp_level) {
      kept = weight * (scene_.lamp_level / brightness);
      Lamp lamp{static_cast<int>(entry.cell) % side, static_cast<int>(entry.cell) / side, {}};
      for (int c = 0; c < 3; ++c) lamp.rgb[c] = (weight - kept) * entry.rgb[c];
      lamps_.push_back(lamp);
    }
    for (int c = 0; c < 3; ++c)
      planes[c][entry.cell] += kept * (entry.rgb[c] + (entry.detail ? detail_shares[c] * (*entry.detail)[c] : 0.0f));
    for (int i = 3; i < source_.count(); ++i) planes[i][entry.cell] += weight;
  }
}

void TileBlur::take_lamps(std::span<const LampEntry> lamps) {
  const int side = source_.side();
  for (const LampEntry& entry : lamps) {
    if (lamp_rays_.followed(*entry.lamp)) continue;
    Lamp lamp{static_cast<int>(entry.cell) % side, static_cast<int>(entry.cell) / side, {}, entry.lamp->places};
    for (int c = 0; c < 3; ++c) lamp.rgb[c] = entry.weight * entry.lamp->rgb[c];
    lamps_.push_back(lamp);
  }
  lamp_pixels_ += static_cast<long long>(lamps_.size());
}

void TileBlur::light_in_place(const Lamp& lamp) {
  for (int c = 0; c < 3; ++c) source_.planes[c].at(lamp.x, lamp.y)[0] += lamp.rgb[c];
}

void TileBlur::blur_source(BlurMethod method, int plane, int part, bool transformed) {
  if (method == BlurMethod::Spatial) {
    blurred_.clear();
    for (int i = 0; i < source_.count(); ++i)
      add_blurred(source_.planes[i], lit_, scene_.bank.kernel(plane, part, source_.kernel_of(i)), scene_.plan.kept(),
                  blurred_.planes[i]);
    return;
  }
  for (int i = 0; i < source_.count(); ++i) {
    // The coverage before blur is the same for all colours.
    if (!transformed && i < 4) transform_tile(source_.planes[i], spectrum_.planes[i]);
    product_of_spectra(spectrum_.planes[std::min(i, 3)],
                       scene_.spectra.of(plane, part, source_.kernel_of(i), kernel_spectra_), product_);
    tile_of_spectrum(product_, blurred_.planes[i]);
  }
}

void TileBlur::add_lamps(int plane, int part) {
  for (const Lamp& lamp : lamps_)
    for (int c = 0; c < 3; ++c) {
      const int channel = source_.kernel_of(c);
      if (!scene_.lamps.parted(plane, lamp.places)) {
        add_lamp(lamp, scene_.bank.kernel(plane, part, channel), c, 1.0f);
        continue;
      }
      const float share = 1.0f / static_cast<float>(std::popcount(lamp.places));
      for (int place = 0; place < 16; ++place)
        if (lamp.places >> place & 1) add_lamp(lamp, scene_.lamps.kernel(plane, part, channel, place), c, share);
    }
}

void TileBlur::add_lamp(const Lamp& lamp, const SpreadKernel& kernel, int channel, float share) {
  const float light = share * lamp.rgb[channel];
  const CellBox reached =
      CellBox{lamp.x, lamp.y, lamp.x + 1, lamp.y + 1}.grown(kernel.radius_px).within(scene_.plan.kept());
  for (int y = reached.top; y < reached.bottom; ++y) {
    float* const row = blurred_.planes[channel].at(0, y);
    for (int x = reached.left; x < reached.right; ++x) row[x] += kernel.weight(x - lamp.x, y - lamp.y) * light;
  }
}

void TileBlur::write(int left, int top, Image& seen) const {
  const CellBox kept = scene_.plan.kept();
  const int coverages = source_.coverages();
  for (int y = 0; y < kept.bottom - kept.top && top + y < seen.height; ++y)
    for (int x = 0; x < kept.right - kept.left && left + x < seen.width; ++x)
      for (int c = 0; c < 3; ++c) {
        double light = 0.0, covered = 0.0;
        for (std::size_t part = 0; part < totals_.size(); ++part) {
          const double weight = scene_.bank.parts()[part].weight;
          light += weight * *totals_[part].planes[c].at(kept.left + x, kept.top + y);
          covered += weight * *totals_[part].planes[3 + (coverages == 1 ? 0 : c)].at(kept.left + x, kept.top + y);
        }
        // Where no light from within the picture arrives at all, the pixel's own is the best guess.
        const float past_edges =
            lamp_rays_.light().pixels.empty() ? 0.0f : lamp_rays_.light().at(kept.left + x, kept.top + y)[c];
        seen.at(left + x, top + y)[c] = past_edges + (covered > 0.0 ? static_cast<float>(light / covered)
                                                                    : scene_.picture.radiance.at(left + x, top + y)[c]);
      }
}

}  // namespace sturm
