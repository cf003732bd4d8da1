#include "stages/see_stage.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/files/error.h"
#include "stages/stopwatch.h"
#include "wavefront/layers/guessed_background.h"
#include "wavefront/layers/kernel_bank.h"
#include "wavefront/layers/lamps.h"
#include "wavefront/layers/primaries.h"
#include "wavefront/layers/ray_kernels.h"
#include "wavefront/layers/unmixed_edges.h"
#include "wavefront/layers/wave_kernels.h"
#include "wavefront/psf/pupil_wave.h"

namespace sturm {

namespace {

KernelModel kernels_of(const SeeSettings& settings, int parts) {
  if (settings.psf == SeenPsf::Waves)
    return wave_kernels(settings.eye, settings.accommodation_D, settings.pixel_slope, settings.chromatic);
  return ray_kernels(settings.eye, settings.accommodation_D, settings.pixel_slope, {parts, settings.chromatic});
}

bool one_distance(const LayeredPicture& picture, std::span<const PictureLayer> layers) {
  const auto all_alike = [](const std::vector<double>& v) {
    return std::all_of(v.begin(), v.end(), [&](double x) { return x == v.front(); });
  };
  return layers.empty() && all_alike(picture.vergence_D);
}

/// The vergences of everything that may be seen.
std::vector<double> all_vergences(const LayeredPicture& picture) {
  std::vector<double> all = picture.vergence_D;
  for (const HiddenPixel& pixel : picture.hidden) all.push_back(pixel.vergence_D);
  return all;
}

/// Whether any blur shows detail. That is no more than the colour that it is added to: from a share of 2⁻²⁵ down,
/// single precision drops the sum.
bool shows_detail(const KernelBank& bank) {
  constexpr float least = 0x1p-25f;
  for (int plane = 0; plane < static_cast<int>(bank.planes_D().size()); ++plane)
    for (int channel = 0; channel < bank.channels(); ++channel)
      if (bank.detail_share(plane, channel) > least) return true;
  return false;
}

/// A picture on its way.
struct SeeRun {
  std::function<void(double fraction)> progress;  ///< may be empty
  Stopwatch watch = {};
  SeenPicture seen = {};

  /// For the planes of a picture with its hidden pixels.
  KernelBank bank_for(const LayeredPicture& picture, const KernelModel& model) {
    KernelBank bank(model, picture.hidden.empty() ? planes_for(picture.vergence_D, model.reach_px_per_D)
                                                  : planes_for(all_vergences(picture), model.reach_px_per_D));
    seen.seconds["kernels"] = watch.lap();
    return bank;
  }

  /// `picture.hidden` has what is known.
  void blur(LayeredPicture& picture, const KernelBank& bank, std::span<const std::size_t> edges) {
    seen.hidden_guessed = add_guessed_background(picture, bank, edges);
    seen.seconds["hidden_surfaces"] = watch.lap();
    seen.radiance = blur_layers(picture, bank, seen.work, progress);
    seen.seconds["blur"] = watch.lap();
    seen.planes_D = bank.planes_D();
    for (std::size_t i = 0; i < seen.planes_D.size(); ++i) seen.radii_px.push_back(bank.radius_px(static_cast<int>(i)));
  }
};

/// Runs `work()`; what cannot be computed of a blur is wrong input.
template <class Work>
auto computed(const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw InputError("", "", error.what(),
                     "a blur that can be computed: a smaller picture, pupil or distance to focus");
  }
}

int parts_of(const SeeSettings& settings, bool pupil_as_a_whole) {
  return settings.psf == SeenPsf::Waves || pupil_as_a_whole ? 1 : settings.parts;
}

/// Runs `see(model, run)` with the kernels of the settings.
template <class See>
SeenPicture seen_through(const SeeSettings& settings, bool pupil_as_a_whole, const See& see) {
  SeeRun run{settings.progress};
  run.seen.parts = parts_of(settings, pupil_as_a_whole);
  computed([&] { see(kernels_of(settings, run.seen.parts), run); });
  return std::move(run.seen);
}

/// Whether no ray comes near the largest radius of a kernel.
bool clearly_small(const SeeSettings& settings, double vergence_D) {
  if (settings.psf == SeenPsf::Waves) return false;
  if (settings.eye.pupil_radius_m == 0.0) return true;
  Light light = monochromatic_light(focus_wavelength_nm);
  if (settings.chromatic)
    for (const double nm : primary_wavelengths_nm) light.push_back({nm, 1.0});
  const double slope =
      PupilWave::of(settings.eye, focus_wavelength_nm).largest_slope(light, vergence_D - settings.accommodation_D);
  return slope < 0.5 * largest_kernel_radius_px * settings.pixel_slope;
}

}  // namespace

SeenPicture see_picture(LayeredPicture& sharp, std::span<const PictureLayer> layers, const SeeSettings& settings) {
  // At one distance the parts of the pupil add up to the whole.
  return seen_through(settings, one_distance(sharp, layers), [&](const KernelModel& model, SeeRun& run) {
    LayeredPicture parted;  // edges and lamps are parted in a copy
    sharp.jump_D = model.reach_px_per_D > 0.0 ? 1.0 / model.reach_px_per_D : std::numeric_limits<double>::infinity();
    const std::vector<std::size_t> edges = edges_of(sharp);
    const bool in_copy = !layers.empty() || !edges.empty() || may_have_lamps(sharp);
    if (in_copy) parted = sharp;
    LayeredPicture& picture = in_copy ? parted : sharp;
    picture.hidden = hidden_by(picture, layers);
    run.seen.hidden_given = static_cast<long long>(picture.hidden.size());
    if (!layers.empty()) unmix_edges(picture, layers, edges);
    if (in_copy) take_lamps(picture);
    if (in_copy && layers.empty()) unmix_edges(picture, layers, edges);  // by colours, which no lamp may be among
    const KernelBank bank = run.bank_for(picture, model);
    picture.shows_detail = shows_detail(bank);
    run.blur(picture, bank, edges);
  });
}

void require_blur(const LayeredPicture& sharp, std::span<const PictureLayer> layers, const SeeSettings& settings) {
  double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
  const auto widen = [&](const std::vector<double>& vergence_D) {
    for (const double v : vergence_D) {
      lowest = std::min(lowest, v);
      highest = std::max(highest, v);
    }
  };
  widen(sharp.vergence_D);
  for (const PictureLayer& layer : layers) widen(layer.vergence_D);
  if (clearly_small(settings, lowest) && clearly_small(settings, highest)) return;
  computed([&] {
    const KernelModel model = kernels_of(settings, parts_of(settings, one_distance(sharp, layers)));
    for (const double vergence_D : {lowest, highest})
      for (int part = 0; part < static_cast<int>(model.parts.size()); ++part)
        for (int channel = 0; channel < model.channels; ++channel) model.kernel(vergence_D, part, channel);
  });
}

SeenPicture see_surfaces(LayeredPicture& picture, const SeeSettings& settings) {
  return seen_through(settings, false, [&](const KernelModel& model, SeeRun& run) {
    run.seen.hidden_given = static_cast<long long>(picture.hidden.size());
    run.blur(picture, run.bank_for(picture, model), edges_of(picture));
  });
}

Json counters_of(const SeenPicture& seen) {
  const BlurCounters& work = seen.work;
  return {{"planes", seen.planes_D.size()},
          {"pupil_parts", seen.parts},
          {"tiles", work.tiles.size()},
          {"tile_side_px", work.tile_side_px},
          {"layers_empty", work.layers(LayerWork::Empty)},
          {"layers_covered", work.layers(LayerWork::Covered)},
          {"layers_unblurred", work.layers(LayerWork::Unblurred)},
          {"layers_spatial", work.layers(LayerWork::Spatial)},
          {"layers_transform", work.layers(LayerWork::Transform)},
          {"lamp_pixels", work.lamp_pixels},
          {"hidden_pixels_given", seen.hidden_given},
          {"hidden_pixels_guessed", seen.hidden_guessed}};
}

std::string explanation_of(const SeenPicture& seen) {
  const auto number = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return std::string(text);
  };
  std::string text =
      std::to_string(seen.planes_D.size()) + " planes, " + std::to_string(seen.parts) + " part(s) of the pupil, " +
      std::to_string(seen.work.tiles.size()) + " tiles of " + std::to_string(seen.work.tile_side_px) +
      " px; hidden pixels: " + std::to_string(seen.hidden_given) + " given, " + std::to_string(seen.hidden_guessed) +
      " guessed\nplanes, nearest first: vergence [D], kernel radius [px]\n";
  for (std::size_t i = seen.planes_D.size(); i-- > 0;)
    text += "  " + number(seen.planes_D[i]) + "  " + std::to_string(seen.radii_px[i]) + "\n";
  text +=
      "tiles (left, top) and their layers, nearest first: . empty, c covered by what lies before it, = copied, s "
      "blurred "
      "tap by tap, F through the spectrum\n";
  for (const TileWork& tile : seen.work.tiles) {
    text += "  (" + std::to_string(tile.left) + ", " + std::to_string(tile.top) + ")  ";
    for (const LayerWork work : tile.layers) text += static_cast<char>(work);
    text += "\n";
  }
  return text;
}

}  // namespace sturm
