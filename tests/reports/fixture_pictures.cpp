// The pictures of the synthetic report.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/images/exr.h"
#include "reports/fixture_eyes.h"
#include "reports/fixture_report.h"

namespace sturm::test {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// What one picture element of a checkerboard with a bright lamp would radiate.
double scene_radiance(int x, int y, int channel, int blur) {
  double sum = 0.0;
  int count = 0;
  for (int v = -blur; v <= blur; ++v) {
    for (int u = -blur; u <= blur; ++u, ++count) {
      const int i = x + u, j = y + v;
      const bool lamp = (i - 64) * (i - 64) + (j - 20) * (j - 20) < 100;
      const bool square = ((i + 1600) / 16 + (j + 1600) / 16) % 2 == 0;
      sum += lamp ? 3.0 : square ? 0.5 - 0.1 * channel : 0.06 + 0.05 * channel;
    }
  }
  return sum / count;
}

void write_image(const std::filesystem::path& file, int blur, double noise, Scatter& scatter) {
  LayeredImage image;
  Image main(128, 128, 3);
  for (int y = 0; y < main.height; ++y) {
    for (int x = 0; x < main.width; ++x) {
      for (int c = 0; c < 3; ++c)
        main.at(x, y)[c] =
            static_cast<float>(std::max(0.0, scene_radiance(x, y, c, blur) * (1.0 + noise * scatter.normal())));
    }
  }
  image.layers[""] = main;
  write_exr(file, image);
}

void write_psf(const std::filesystem::path& file, const PsfSetup& setup, const std::string& model, Scatter& scatter) {
  constexpr int rays = 200000;
  const Matrix2d V = needed_vergence(setup.rx, setup.distance_m);
  const double a = 0.5e-3 * setup.pupil_mm, pixel = psf_pixel_rad(setup);
  Image main(psf_resolution, psf_resolution, 3);
  for (int i = 0; i < rays; ++i) {
    const double r = a * std::sqrt(scatter.uniform()), phi = 2.0 * std::numbers::pi * scatter.uniform();
    const Vector2d image = -(slope_map(model, V, phi) * Vector2d(r * std::cos(phi), r * std::sin(phi)));
    const int x = static_cast<int>(std::floor(image.x() / pixel + 0.5 * psf_resolution));
    const int y = static_cast<int>(std::floor(-image.y() / pixel + 0.5 * psf_resolution));  // rows go down
    if (x < 0 || y < 0 || x >= psf_resolution || y >= psf_resolution) continue;
    for (int c = 0; c < 3; ++c) main.at(x, y)[c] += 0.01f;
  }
  LayeredImage image;
  image.layers[""] = main;
  write_exr(file, image);
}

}  // namespace

void write_synthetic_pictures(const Json& report, const std::filesystem::path& run_folder) {
  Scatter scatter;
  std::filesystem::create_directories(run_folder / "psf");
  std::filesystem::create_directories(run_folder / "images");
  for (const Json& psf : report["psfs"]) {
    const auto* setup = std::find_if(std::begin(psf_setups), std::end(psf_setups),
                                     [&](const PsfSetup& s) { return psf["id"] == s.id; });
    write_psf(run_folder / psf["file"].get<std::string>(), *setup, psf["ray_model"].get<std::string>(), scatter);
    Scatter of_its_own;
    write_psf(run_folder / psf["files"]["predicted"].get<std::string>(), *setup, "power_matrix", of_its_own);
  }
  for (const Json& image : report["images"]) {
    const bool agrees = image["ray_model"] == "power_matrix";
    write_image(run_folder / image["files"]["path_traced"].get<std::string>(), 2, 0.04, scatter);
    write_image(run_folder / image["files"]["predicted"].get<std::string>(), agrees ? 2 : 4, 0.004, scatter);
  }
}

}  // namespace sturm::test
