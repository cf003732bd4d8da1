#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/imageformats/abi.h"

namespace {

/// Runs `work`; no exception may leave a C function.
template <typename Work>
int guarded(char* error, std::size_t error_size, Work work) {
  try {
    work();
    return 0;
  } catch (const std::exception& failure) {
    std::snprintf(error, error_size, "%s", failure.what());
  } catch (...) {
    std::snprintf(error, error_size, "unknown failure");
  }
  return 1;
}

template <typename T>
T* allocate(std::size_t count) {
  auto* memory = static_cast<T*>(std::malloc(count * sizeof(T)));
  if (!memory) throw std::runtime_error("out of memory");
  return memory;
}

}  // namespace

int sturm_imageformats_read(const char* path, std::size_t max_pixels, int* width, int* height, int* channels, float** pixels, char* error,
                            std::size_t error_size) {
  return guarded(error, error_size, [&] {
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;  // values as stored: no multiplication by alpha
    const auto input = OIIO::ImageInput::open(path, &wishes);
    if (!input) throw std::runtime_error(OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 || spec.nchannels > 16)
      throw std::runtime_error("not a two-dimensional image of 1 to 16 channels");
    if (spec.image_pixels() > max_pixels) throw std::runtime_error("more than " + std::to_string(max_pixels) + " pixels");
    float* memory = allocate<float>(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, memory)) {
      std::free(memory);
      throw std::runtime_error(input->geterror());
    }
    *width = spec.width;
    *height = spec.height;
    *channels = spec.nchannels;
    *pixels = memory;
  });
}

int sturm_imageformats_encode_png(const unsigned char* pixels, int width, int height, int channels, unsigned char** bytes, std::size_t* size,
                                  char* error, std::size_t error_size) {
  return guarded(error, error_size, [&] {
    const auto output = OIIO::ImageOutput::create("png");
    if (!output) throw std::runtime_error(OIIO::geterror());
    std::vector<unsigned char> encoded;
    OIIO::Filesystem::IOVecOutput memory_file(encoded);
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc::UINT8);
    spec["oiio:ColorSpace"] = "sRGB";
    if (!output->set_ioproxy(&memory_file) || !output->open("memory.png", spec) || !output->write_image(OIIO::TypeDesc::UINT8, pixels) ||
        !output->close())
      throw std::runtime_error(output->geterror());
    *bytes = allocate<unsigned char>(encoded.size());
    std::memcpy(*bytes, encoded.data(), encoded.size());
    *size = encoded.size();
  });
}

void sturm_imageformats_free(void* memory) { std::free(memory); }
