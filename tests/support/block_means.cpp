// Writes tests/reference/scene_plain/block_means.json from somebody else's renderings of that scene:
//   block_means VARIANT SAMPLES SEED_A.exr SEED_B.exr [VARIANT SAMPLES SEED_A.exr SEED_B.exr ...] > block_means.json
// A block is 16×16 pixels; its mean is summed in double and printed with nine digits, enough for a float.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr int block = 16;

void print_block_means(const char* path) {
  Imf::InputFile file(path);
  const Imath::Box2i window = file.header().dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  std::vector<std::vector<float>> channels(3, std::vector<float>(static_cast<std::size_t>(width) * height));
  Imf::FrameBuffer frame;
  const char* names[] = {"R", "G", "B"};
  for (int k = 0; k < 3; ++k) {
    if (!file.header().channels().findChannel(names[k])) throw std::runtime_error(std::string(path) + " has no channel " + names[k]);
    char* base = reinterpret_cast<char*>(channels[k].data()) -
                 (window.min.x + static_cast<long>(window.min.y) * width) * static_cast<long>(sizeof(float));
    frame.insert(names[k], Imf::Slice(Imf::FLOAT, base, sizeof(float), sizeof(float) * width));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  std::printf("[");
  for (int by = 0; by < height / block; ++by) {
    for (int bx = 0; bx < width / block; ++bx) {
      std::printf("%s[", bx + by ? ",\n" : "");
      for (int k = 0; k < 3; ++k) {
        double sum = 0.0;
        for (int y = by * block; y < (by + 1) * block; ++y)
          for (int x = bx * block; x < (bx + 1) * block; ++x)
            sum += static_cast<double>(channels[k][static_cast<std::size_t>(y) * width + x]);
        std::printf("%s%.9g", k ? ", " : "", sum / (block * block));
      }
      std::printf("]");
    }
  }
  std::printf("]");
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 5 || (argc - 1) % 4 != 0) {
    std::fprintf(stderr, "usage: block_means VARIANT SAMPLES SEED_A.exr SEED_B.exr ...\n");
    return 2;
  }
  std::printf(
      "{\"source\": \"Cycles (Blender 3.4.1), clamping, light threshold, adaptive sampling and denoising off, 1 px box filter, 256x256\",\n"
      "\"what\": \"means of 16x16 pixel blocks, row by row from the upper left, [R, G, B] linear Rec. 709 radiance\",\n\"variants\": {");
  for (int i = 1; i < argc; i += 4) {
    std::printf("%s\"%s\": {\"samples_per_pixel_of_each_seed\": %d, \"seeds\": [\n", i > 1 ? ",\n" : "\n", argv[i], std::atoi(argv[i + 1]));
    print_block_means(argv[i + 2]);
    std::printf(",\n");
    print_block_means(argv[i + 3]);
    std::printf("]}");
  }
  std::printf("}}\n");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "block_means: %s\n", error.what());
  return 3;
}
