#include "io/images/image_formats.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/files/code_folder.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/images/imageformats/abi.h"

namespace sturm {

namespace {

/// The functions of the module. Never closed: OpenImageIO keeps threads and thread-local memory.
struct Module {
  decltype(&sturm_imageformats_read) read;
  decltype(&sturm_imageformats_read_memory) read_memory;
  decltype(&sturm_imageformats_encode_png) encode_png;
  decltype(&sturm_imageformats_free) free;
};

Module open_module() {
  const std::filesystem::path own = folder_of_this_code();
  std::string reasons;
  // Beside a library that is used from another program; else the same place relative to the program in the build tree
  // and where it is installed.
  for (const std::filesystem::path folder : {".", "../lib/sturm", STURM_MODULE_FOLDER}) {
    const std::filesystem::path file = (own / folder / "sturm_imageformats.so").lexically_normal();
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) {
      reasons += std::string("\n  ") + dlerror();
      continue;
    }
    const Module module{
        reinterpret_cast<decltype(Module::read)>(dlsym(library, "sturm_imageformats_read")),
        reinterpret_cast<decltype(Module::read_memory)>(dlsym(library, "sturm_imageformats_read_memory")),
        reinterpret_cast<decltype(Module::encode_png)>(dlsym(library, "sturm_imageformats_encode_png")),
        reinterpret_cast<decltype(Module::free)>(dlsym(library, "sturm_imageformats_free"))};
    if (!module.read || !module.read_memory || !module.encode_png || !module.free)
      throw RuntimeFailure(file.string() + " is not the image format module of this program");
    return module;
  }
  throw RuntimeFailure("the image format module (PNG, JPEG, textures) could not be loaded:" + reasons);
}

const Module& module() {
  static const Module opened = open_module();
  return opened;
}

/// What a function of the module decodes; `name` is for messages.
template <class Read>
Image decoded(const std::string& name, const Read& read) {
  Image image;
  float* pixels = nullptr;
  std::array<char, 1024> error{};
  if (read(image, &pixels, error.data(), error.size())) {
    std::string reason = error.data();
    std::replace(reason.begin(), reason.end(), '\n', ';');
    throw InputError(name, "", reason, "an image that OpenImageIO reads");
  }
  const std::unique_ptr<float, decltype(Module::free)> owner(pixels, module().free);
  image.pixels.assign(pixels, pixels + static_cast<std::size_t>(image.width) * image.height * image.channels);
  return image;
}

template <class Integer>
std::vector<unsigned char> encoded_png(const Image& display) {
  constexpr auto largest = static_cast<float>(std::numeric_limits<Integer>::max());
  std::vector<Integer> rounded(display.pixels.size());
  std::transform(display.pixels.begin(), display.pixels.end(), rounded.begin(), [](float value) {
    if (!std::isfinite(value)) throw std::invalid_argument("a PNG cannot hold a value that is not finite");
    return static_cast<Integer>(std::lround(largest * std::clamp(value, 0.0f, 1.0f)));
  });
  const Module& formats = module();
  unsigned char* bytes = nullptr;
  std::size_t size = 0;
  std::array<char, 1024> error{};
  if (formats.encode_png(rounded.data(), std::numeric_limits<Integer>::digits, display.width, display.height,
                         display.channels, &bytes, &size, error.data(), error.size()))
    throw RuntimeFailure(std::string("PNG encoding failed: ") + error.data());
  const std::unique_ptr<unsigned char, decltype(Module::free)> owner(bytes, formats.free);
  return {bytes, bytes + size};
}

}  // namespace

StoredImage read_stored_image(const std::filesystem::path& path) {
  require_plain_file(path, "an image");
  int bits = 0;
  Image stored = decoded(path.string(), [&](Image& image, float** pixels, char* error, std::size_t error_size) {
    return module().read(path.c_str(), most_pixels, &image.width, &image.height, &image.channels, &bits, pixels, error,
                         error_size);
  });
  return {std::move(stored), bits};
}

Image read_image(const std::filesystem::path& path) {
  return read_stored_image(path).image;
}

Image read_embedded_image(std::span<const unsigned char> bytes, const std::string& name) {
  return decoded(name, [&](Image& image, float** pixels, char* error, std::size_t error_size) {
    return module().read_memory(bytes.data(), bytes.size(), most_pixels, &image.width, &image.height, &image.channels,
                                pixels, error, error_size);
  });
}

std::vector<unsigned char> encode_png(const Image& display, int bits) {
  if (display.width < 1 || display.height < 1 || (display.channels != 1 && display.channels != 3))
    throw std::invalid_argument("a PNG is made of an image with 1 or 3 channels");
  if (bits == 8) return encoded_png<std::uint8_t>(display);
  if (bits == 16) return encoded_png<std::uint16_t>(display);
  throw std::invalid_argument("a PNG has 8 or 16 bits");
}

}  // namespace sturm
