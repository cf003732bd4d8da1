#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/images/imageformats/abi.h"

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

/// No multiplication by alpha.
OIIO::ImageSpec values_as_stored() {
  OIIO::ImageSpec wishes;
  wishes["oiio:UnassociatedAlpha"] = 1;
  return wishes;
}

/// All pixels of an opened file, in memory from malloc; `input` is null where it could not be opened.
void read_opened(std::unique_ptr<OIIO::ImageInput> input, std::size_t max_pixels, int* width, int* height,
                 int* channels, float** pixels) {
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
}

}  // namespace

int sturm_imageformats_read(const char* path, std::size_t max_pixels, int* width, int* height, int* channels, int* bits,
                            float** pixels, char* error, std::size_t error_size) {
  return guarded(error, error_size, [&] {
    const OIIO::ImageSpec wishes = values_as_stored();
    auto input = OIIO::ImageInput::open(path, &wishes);
    if (input) {
      const OIIO::TypeDesc stored = input->spec().format;
      *bits = stored.is_floating_point()
                  ? 0
                  : input->spec().get_int_attribute("oiio:BitsPerSample", static_cast<int>(8 * stored.basesize()));
    }
    read_opened(std::move(input), max_pixels, width, height, channels, pixels);
  });
}

int sturm_imageformats_read_memory(const unsigned char* bytes, std::size_t size, std::size_t max_pixels, int* width,
                                   int* height, int* channels, float** pixels, char* error, std::size_t error_size) {
  return guarded(error, error_size, [&] {
    constexpr unsigned char png_signature[] = {0x89, 'P', 'N', 'G'}, jpeg_signature[] = {0xFF, 0xD8, 0xFF};
    const auto begins_with = [&](const auto& signature) {
      return size >= sizeof signature && std::memcmp(bytes, signature, sizeof signature) == 0;
    };
    const char* format = begins_with(png_signature) ? "png" : begins_with(jpeg_signature) ? "jpeg" : nullptr;
    if (!format) throw std::runtime_error("neither a PNG nor a JPEG file");
    OIIO::Filesystem::IOMemReader memory_file(const_cast<unsigned char*>(bytes), size);  // it only reads
    auto input = OIIO::ImageInput::create(format);
    if (!input) throw std::runtime_error(OIIO::geterror());
    OIIO::ImageSpec spec;
    if (!input->set_ioproxy(&memory_file) || !input->open(std::string("memory.") + format, spec, values_as_stored()))
      throw std::runtime_error(input->geterror());
    read_opened(std::move(input), max_pixels, width, height, channels, pixels);
  });
}

int sturm_imageformats_encode_png(const void* pixels, int bits, int width, int height, int channels,
                                  unsigned char** bytes, std::size_t* size, char* error, std::size_t error_size) {
  return guarded(error, error_size, [&] {
    const auto output = OIIO::ImageOutput::create("png");
    if (!output) throw std::runtime_error(OIIO::geterror());
    std::vector<unsigned char> encoded;
    OIIO::Filesystem::IOVecOutput memory_file(encoded);
    const OIIO::TypeDesc type = bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec(width, height, channels, type);
    spec["oiio:ColorSpace"] = "sRGB";
    if (!output->set_ioproxy(&memory_file) || !output->open("memory.png", spec) || !output->write_image(type, pixels) ||
        !output->close())
      throw std::runtime_error(output->geterror());
    *bytes = allocate<unsigned char>(encoded.size());
    std::memcpy(*bytes, encoded.data(), encoded.size());
    *size = encoded.size();
  });
}

void sturm_imageformats_free(void* memory) {
  std::free(memory);
}
