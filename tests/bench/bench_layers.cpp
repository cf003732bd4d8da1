// How long it takes to see a picture with depth, after loading: the bank of kernels, what lamps and edges ask for,
// the background behind edges, and the blur with its details.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "bench/timing.h"
#include "io/files/machine.h"
#include "wavefront/layers/guessed_background.h"
#include "wavefront/layers/lamps.h"
#include "wavefront/layers/layer_blur.h"
#include "wavefront/layers/ray_kernels.h"
#include "wavefront/layers/unmixed_edges.h"

namespace {

using namespace sturm;

/// A room: floor, back wall, four objects before it, from 0.4 m to 5 m.
LayeredPicture room(int width, int height) {
  LayeredPicture picture;
  picture.radiance = Image(width, height, 3);
  picture.vergence_D.resize(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width, v = (y + 0.5) / height;
      double vergence = std::max(0.2, 0.2 + 3.0 * (v - 0.6));
      const double objects[4][4] = {
          {0.2, 0.6, 0.08, 2.5}, {0.45, 0.5, 0.1, 1.2}, {0.7, 0.65, 0.07, 1.8}, {0.85, 0.4, 0.06, 0.6}};
      for (const auto& [cx, cy, r, d] : objects)
        if (std::hypot((u - cx) * width / height, v - cy) < r) vergence = std::max(vergence, d);
      picture.vergence_D[static_cast<std::size_t>(y) * width + x] = vergence;
      for (int c = 0; c < 3; ++c)
        picture.radiance.at(x, y)[c] = static_cast<float>(
            0.5 + 0.3 * std::sin(40.0 * u * (c + 1)) * std::cos(30.0 * v) + 0.1 * std::sin(0.9 * x + 0.7 * y));
    }
  return picture;
}

struct Seconds {
  double kernels, lamps_and_edges, background, blur;
  double all() const { return kernels + lamps_and_edges + background + blur; }
};

Seconds see_once(LayeredPicture& picture, const Eye& eye, double pixel_slope, int parts, BlurCounters& work) {
  Seconds seconds{};
  picture.hidden.clear();
  picture.coverage.clear();
  picture.shows_detail = true;
  KernelModel model;
  std::optional<KernelBank> bank;
  std::vector<std::size_t> edges;
  seconds.kernels = bench::seconds([&] {
    model = ray_kernels(eye, 0.0, pixel_slope, {parts, false});
    picture.jump_D = 1.0 / model.reach_px_per_D;
    bank.emplace(model, planes_for(picture.vergence_D, model.reach_px_per_D));
  });
  seconds.lamps_and_edges = bench::seconds([&] {
    take_lamps(picture);
    edges = edges_of(picture);
    unmix_edges(picture, {}, edges);
  });
  seconds.background = bench::seconds([&] { add_guessed_background(picture, *bank, edges); });
  seconds.blur = bench::seconds([&] { blur_layers(picture, *bank, work); });
  return seconds;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"time of layered blur: a room at 46 degrees through a pupil of 5.7 mm"};
  int width = 1280, height = 720, rounds = 5;
  app.add_option("--width", width, "of the picture [px]");
  app.add_option("--height", height, "of the picture [px]");
  app.add_option("--rounds", rounds, "the median of so many is shown");
  CLI11_PARSE(app, argc, argv);
  const double pixel_slope = 2.0 * std::tan(23.0 * std::numbers::pi / 180.0) / width;
  const Eye eye = Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 5.7e-3);
  LayeredPicture picture = room(width, height);
  for (const int parts : {1, 4}) {
    std::vector<double> all;
    Seconds last{};
    BlurCounters work;
    for (int round = 0; round < rounds; ++round) {
      work = {};
      last = see_once(picture, eye, pixel_slope, parts, work);
      all.push_back(last.all());
    }
    std::printf(
        "%d part(s): median %.3f s; last: kernels %.3f, lamps and edges %.3f, background %.3f, blur %.3f s; layers: "
        "%zu planes, "
        "%lld through the spectrum, %lld tap by tap, %lld copied, %lld covered; peak memory %.0f MB\n",
        parts, bench::median(all), last.kernels, last.lamps_and_edges, last.background, last.blur,
        work.tiles[0].layers.size(), work.layers(LayerWork::Transform), work.layers(LayerWork::Spatial),
        work.layers(LayerWork::Unblurred), work.layers(LayerWork::Covered),
        1e-6 * static_cast<double>(peak_memory_bytes()));
  }
  return 0;
}
