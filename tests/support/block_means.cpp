// Writes tests/reference/scene_plain/block_means.json from somebody else's renderings of that scene:
//   block_means VARIANT SAMPLES SEED_A.exr SEED_B.exr [VARIANT SAMPLES SEED_A.exr SEED_B.exr ...] > block_means.json
// A block is 16×16 pixels; its mean is summed in double and printed with nine digits, enough for a float. Blocks do not
// feel a blur that is wrong by a fraction of a pixel, so the profile across the lamp's two horizontal edges, where it
// shows most, is kept row by row.
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
constexpr int lamp_x = 112, lamp_y = 24, lamp_width = 32,
              lamp_height = 24;  // the lamp covers rows 31…41 all along this rectangle

struct Picture {
  int width, height;
  std::vector<float> channels[3];

  double at(int x, int y, int k) const {
    return static_cast<double>(channels[k][static_cast<std::size_t>(y) * width + x]);
  }
};

Picture read(const char* path) {
  Imf::InputFile file(path);
  const Imath::Box2i window = file.header().dataWindow();
  Picture picture{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, {}};
  Imf::FrameBuffer frame;
  const char* names[] = {"R", "G", "B"};
  for (int k = 0; k < 3; ++k) {
    if (!file.header().channels().findChannel(names[k]))
      throw std::runtime_error(std::string(path) + " has no channel " + names[k]);
    std::vector<float>& channel = picture.channels[k];
    channel.resize(static_cast<std::size_t>(picture.width) * picture.height);
    const long first = window.min.x + static_cast<long>(window.min.y) * picture.width;
    frame.insert(names[k], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(channel.data() - first), sizeof(float),
                                      sizeof(float) * picture.width));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return picture;
}

std::vector<double> block_means(const Picture& picture) {
  std::vector<double> means;
  for (int by = 0; by < picture.height / block; ++by)
    for (int bx = 0; bx < picture.width / block; ++bx)
      for (int k = 0; k < 3; ++k) {
        double sum = 0.0;
        for (int y = by * block; y < (by + 1) * block; ++y)
          for (int x = bx * block; x < (bx + 1) * block; ++x) sum += picture.at(x, y, k);
        means.push_back(sum / (block * block));
      }
  return means;
}

std::vector<double> lamp_rows(const Picture& picture) {
  std::vector<double> rows;
  for (int y = lamp_y; y < lamp_y + lamp_height; ++y) {
    double sum = 0.0;
    for (int x = lamp_x; x < lamp_x + lamp_width; ++x) sum += picture.at(x, y, 1);
    rows.push_back(sum / lamp_width);
  }
  return rows;
}

void print(const char* name, const std::vector<double>& values) {
  std::printf("\"%s\": [", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::printf("%s%.9g", i == 0 ? "" : i % 12 == 0 ? ",\n" : ", ", values[i]);
  std::printf("]");
}

void print_seed(const char* path) {
  const Picture picture = read(path);
  std::printf("{");
  print("block_means", block_means(picture));
  std::printf(",\n");
  print("lamp_rows", lamp_rows(picture));
  std::printf("}");
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 5 || (argc - 1) % 4 != 0) {
    std::fprintf(stderr, "usage: block_means VARIANT SAMPLES SEED_A.exr SEED_B.exr ...\n");
    return 2;
  }
  std::printf(
      R"({"source": "Cycles (Blender 3.4.1); clamping, light threshold, adaptive sampling and denoising off; 1 px box filter; 256x256",
"block_means": "means of 16x16 pixels, row by row from the upper left, R G B of each, linear Rec. 709 radiance",
"lamp_rows": "mean G of each row of lamp_rectangle", "lamp_rectangle": {"x": %d, "y": %d, "width": %d, "height": %d},
"variants": {)",
      lamp_x, lamp_y, lamp_width, lamp_height);
  for (int i = 1; i < argc; i += 4) {
    std::printf("%s\n\"%s\": {\"samples_per_pixel_of_each_seed\": %d, \"seeds\": [\n", i > 1 ? "," : "", argv[i],
                std::atoi(argv[i + 1]));
    print_seed(argv[i + 2]);
    std::printf(",\n");
    print_seed(argv[i + 3]);
    std::printf("]}");
  }
  std::printf("}}\n");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "block_means: %s\n", error.what());
  return 3;
}
