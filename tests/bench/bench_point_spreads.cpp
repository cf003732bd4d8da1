// How long banks of point spreads take: eleven distances of a measured eye through a pupil of 5.7 mm.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <numbers>

#include "bench/timing.h"
#include "support/wave_cases.h"
#include "wavefront/layers/kernel_bank.h"
#include "wavefront/layers/wave_kernels.h"
#include "wavefront/psf/ray_fan.h"

namespace {

using namespace sturm;

constexpr int distances = 11;
constexpr double step_D = 0.25;

/// Seconds by the clock on the wall, and of the processors, which other programs do not change.
template <class Work>
void report(const char* what, int rounds, const Work& work) {
  std::vector<double> wall;
  const std::clock_t start = std::clock();
  for (int round = 0; round < rounds; ++round) wall.push_back(bench::seconds(work));
  const double processor = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / rounds;
  std::printf("%s: median %.3f s, %.3f s of processor time\n", what, bench::median(wall), processor);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"time of banks of point spreads: 11 distances of a measured eye, 5.7 mm"};
  int rounds = 3;
  app.add_option("--rounds", rounds, "the median of so many is shown");
  CLI11_PARSE(app, argc, argv);
  std::vector<double> metres;
  for (const double c : testing::hofer_eye(5)) metres.push_back(1e-6 * c);
  const Eye eye = Eye::with(ZernikeWave::from_examiner(metres, 3e-3), SecondOrder::LeastSquares, std::nullopt, 5.7e-3);
  const PupilWave pupil = PupilWave::of(eye, 555.0);
  report("rays, 2^20 of one wavelength, on cells of 0.25'", rounds, [&] {
    const RayFan fan(pupil, monochromatic_light(555.0), usual_ray_count);
    for (int i = 0; i < distances; ++i) cells_of(fan, step_D * i, 0.25 * testing::arcmin, 257);
  });
  std::vector<double> planes;
  for (int i = 0; i < distances; ++i) planes.push_back(step_D * i);
  const double pixel_slope = 2.0 * std::tan(23.0 * std::numbers::pi / 180.0) / 1280.0;
  for (const bool chromatic : {false, true})
    report(chromatic ? "waves of red, green and blue on the pixels of a picture"
                     : "waves of white light on the pixels of a picture",
           rounds, [&] { KernelBank(wave_kernels(eye, 0.0, pixel_slope, chromatic), planes); });
  return 0;
}
