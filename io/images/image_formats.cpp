#include "io/images/image_formats.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "io/files/code_folder.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/images/claimed_size.h"
#include "io/images/imageformats/abi.h"
#include "io/images/picture_format.h"
#include "io/images/png_input.h"
#include "io/images/tiff_header.h"
#include "io/images/upright.h"

namespace sturm {

namespace {

using namespace std::string_view_literals;

/// The functions of the module. Never closed: OpenImageIO keeps threads and thread-local memory.
struct Module {
  decltype(&sturm_imageformats_read) read;
  decltype(&sturm_imageformats_read_memory) read_memory;
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
        reinterpret_cast<decltype(Module::free)>(dlsym(library, "sturm_imageformats_free"))};
    if (!module.read || !module.read_memory || !module.free)
      throw RuntimeFailure(file.string() + " is not the image format module of this program");
    return module;
  }
  throw RuntimeFailure("the image format module (PNG, JPEG, textures) could not be loaded:" + reasons);
}

const Module& module() {
  static const Module opened = open_module();
  return opened;
}

/// Of an ICC profile.
void follow_profile(std::span<const unsigned char> profile, StoredImage& stored) {
  if (const auto note = note_of_profile(profile, stored.bits > 0)) stored.colours.notes.push_back(*note);
}

/// What else the module has found, and the picture as it is to be seen.
void describe(const sturm_imageformats_pixels& pixels, StoredImage& stored) {
  if (pixels.orientation > 1 && pixels.orientation <= 8) {
    stored.image = upright(std::move(stored.image), pixels.orientation);
    stored.notes.push_back("turned as its orientation " + std::to_string(pixels.orientation) + " says");
  }
  stored.was_cmyk = pixels.was_cmyk != 0;
  if (stored.was_cmyk) stored.notes.emplace_back("its colours for printing (CMYK) are converted without a profile");
  if (pixels.has_more) stored.notes.emplace_back("the first of its pictures is taken");
  if (!pixels.profile) return;
  const std::unique_ptr<unsigned char, decltype(Module::free)> owner(pixels.profile, module().free);
  follow_profile({pixels.profile, pixels.profile_size}, stored);
}

/// What a function of the module decodes; `name` is for messages.
template <class Read>
StoredImage decoded(const std::string& name, const Read& read) {
  StoredImage stored;
  sturm_imageformats_pixels pixels{&stored.image.pixels, [](void* owner, std::size_t count) {
                                     auto& values = *static_cast<std::vector<float>*>(owner);
                                     values.resize(count);
                                     return values.data();
                                   }};
  std::array<char, 1024> error{};
  if (read(pixels, error.data(), error.size())) {
    std::string reason = error.data();
    std::replace(reason.begin(), reason.end(), '\n', ';');
    throw InputError(name, "", reason.empty() ? "pixels that break off" : reason, "an image that OpenImageIO reads");
  }
  stored.image.width = pixels.width;
  stored.image.height = pixels.height;
  stored.image.channels = pixels.channels;
  stored.bits = pixels.bits;
  describe(pixels, stored);
  return stored;
}

/// Nothing for other formats, and for PNG files that OpenImageIO knows more of.
std::optional<StoredImage> read_by_libpng(const PictureFormat& format, const BytesAt& bytes_at, std::uint64_t most,
                                          const std::string& name) {
  if (format.reader != "png"sv) return std::nullopt;
  try {
    std::optional<StoredPng> png = read_png(bytes_at, most);
    if (!png) return std::nullopt;
    StoredImage stored;
    stored.image = std::move(png->image);
    stored.bits = png->bits;
    if (!png->profile.empty())
      follow_profile({reinterpret_cast<const unsigned char*>(png->profile.data()), png->profile.size()}, stored);
    return stored;
  } catch (const std::runtime_error& error) {
    throw InputError(name, "", error.what(), "a complete PNG picture");
  }
}

/// Colours that are stored times alpha.
void divide_by_alpha(const PictureFormat& format, const BytesAt& bytes_at, StoredImage& stored) {
  Image& image = stored.image;
  if (format.reader != "tiff"sv || image.channels % 2 != 0 || !tiff_is_multiplied_by_alpha(bytes_at)) return;
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < image.pixels.size(); i += channels)
    for (std::size_t c = 0; c + 1 < channels; ++c)
      if (const float alpha = image.pixels[i + channels - 1]; alpha > 0.0f) image.pixels[i + c] /= alpha;
  stored.notes.emplace_back("its colours are divided by alpha, as they were stored times it");
}

/// Adobe's programs store ink the other way round, and OpenImageIO takes all files for theirs.
void require_ink_of_adobe(const BytesAt& bytes_at, std::uint64_t size, const std::string& name) {
  if (bytes_at(0, size).find("\xff\xee\0\x0e"
                             "Adobe"sv) == std::string::npos)
    throw InputError(name, "", "CMYK without Adobe's marker: 0 may be full ink or none", "red, green and blue");
}

/// What a PNG says of its colours, beside an embedded profile.
void follow_chunks(const PictureFormat& format, const BytesAt& bytes_at, StoredImage& stored) {
  if (format.reader != "png"sv) return;
  StatedColours stated = colours_of_png(bytes_at);
  stored.colours.gamma = stated.gamma;
  stored.colours.notes.insert(stored.colours.notes.end(), stated.notes.begin(), stated.notes.end());
}

/// What the bytes of a file say of its numbers and OpenImageIO does not.
void follow_bytes(const PictureFormat& format, const BytesAt& bytes_at, std::uint64_t size, const std::string& name,
                  StoredImage& stored) {
  if (stored.was_cmyk && format.reader == "jpeg"sv) require_ink_of_adobe(bytes_at, size, name);
  divide_by_alpha(format, bytes_at, stored);
  follow_chunks(format, bytes_at, stored);
}

/// How many pixels a picture may have. Throws InputError about `name` for claims that the bytes cannot fulfil.
std::uint64_t admitted_pixels(const PictureFormat& format, const BytesAt& bytes_at, std::uint64_t size,
                              const std::string& name) {
  const std::uint64_t most = most_pixels_of(format, size);
  try {
    if (const auto claim = claimed_size(format, bytes_at);
        claim && claim->height > 0 && claim->width > most / claim->height)
      throw std::runtime_error("a header that claims " + std::to_string(claim->width) + " x " +
                               std::to_string(claim->height) + " pixels in a file of " + std::to_string(size) +
                               " bytes");
  } catch (const std::runtime_error& error) {
    throw InputError(name, "", error.what(), std::string("a complete ") + format.reader + " picture");
  }
  return most;
}

}  // namespace

void require_image_formats() {
  static_cast<void>(module());
}

StoredImage read_stored_image(const std::filesystem::path& path) {
  require_plain_file(path, "an image");
  std::ifstream file(path, std::ios::binary);
  const BytesAt bytes_at = [&](std::uint64_t offset, std::size_t count) {
    std::string bytes(count, '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(offset)).read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
  };
  const std::optional<PictureFormat> format = picture_format(bytes_at);
  if (!format) throw InputError(path.string(), "", "a file of another kind", picture_formats);
  const std::uint64_t size = std::filesystem::file_size(path);
  const std::uint64_t most = admitted_pixels(*format, bytes_at, size, path.string());
  std::optional<StoredImage> stored = read_by_libpng(*format, bytes_at, most, path.string());
  if (!stored)
    stored = decoded(path.string(), [&](sturm_imageformats_pixels& pixels, char* error, std::size_t error_size) {
      return module().read(format->reader, path.c_str(), most, &pixels, error, error_size);
    });
  follow_bytes(*format, bytes_at, size, path.string(), *stored);
  return std::move(*stored);
}

Image read_image(const std::filesystem::path& path) {
  return read_stored_image(path).image;
}

StoredImage read_embedded_image(std::span<const unsigned char> bytes, const std::string& name) {
  const BytesAt bytes_at = [&](std::uint64_t offset, std::size_t count) {
    const auto part = bytes.subspan(std::min<std::size_t>(offset, bytes.size()));
    return std::string(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(std::min(count, part.size())));
  };
  const auto format = picture_format(bytes_at);
  if (!format || (format->reader != "png"sv && format->reader != "jpeg"sv))
    throw InputError(name, "", "neither a PNG nor a JPEG file", "an image that OpenImageIO reads");
  const std::uint64_t most = admitted_pixels(*format, bytes_at, bytes.size(), name);
  std::optional<StoredImage> stored = read_by_libpng(*format, bytes_at, most, name);
  if (!stored)
    stored = decoded(name, [&](sturm_imageformats_pixels& pixels, char* error, std::size_t error_size) {
      return module().read_memory(format->reader, bytes.data(), bytes.size(), most, &pixels, error, error_size);
    });
  follow_bytes(*format, bytes_at, bytes.size(), name, *stored);
  return std::move(*stored);
}

}  // namespace sturm
