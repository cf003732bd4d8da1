// Writes the mean of pictures as a small EXR of half floats, as tests/reference/*/reference_dof20.exr was made from
// somebody else's renderings with several seeds:
//   mean_picture OUT.exr SEED_A.exr SEED_B.exr ...
// Rounding to half is at most 2^-11 of a value: a relative squared error below 1e-7, far under the noise of any picture
// here.
#include <OpenEXR/ImfRgbaFile.h>

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <vector>

#include "io/images/exr.h"

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: mean_picture OUT.exr PICTURE.exr ...\n");
    return 2;
  }
  try {
    std::vector<double> sum;
    int width = 0, height = 0;
    for (int i = 2; i < argc; ++i) {
      const sturm::Image picture = sturm::read_exr(argv[i]).layers.at("");
      if (i == 2) {
        width = picture.width;
        height = picture.height;
        sum.assign(picture.pixels.size(), 0.0);
      }
      if (picture.pixels.size() != sum.size()) throw std::runtime_error("pictures of different sizes");
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += static_cast<double>(picture.pixels[k]);
    }
    std::vector<Imf::Rgba> pixels;
    const auto mean = [&](std::size_t k) { return half(static_cast<float>(sum[k] / (argc - 2))); };
    const std::size_t channels = sum.size() / (static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t k = 0; k < sum.size(); k += channels) pixels.emplace_back(mean(k), mean(k + 1), mean(k + 2));
    Imf::RgbaOutputFile file(argv[1], width, height, Imf::WRITE_RGB, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y,
                             Imf::PIZ_COMPRESSION);
    file.setFrameBuffer(pixels.data(), 1, static_cast<std::size_t>(width));
    file.writePixels(height);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mean_picture: %s\n", error.what());
    return 3;
  }
}
