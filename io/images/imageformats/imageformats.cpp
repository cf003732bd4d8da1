#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
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

/// How many bytes of pixels a byte of a TIFF file can stand for, by its compression; of fax, Zstandard and LZMA
/// generously.
double largest_tiff_ratio(int compression) {
  constexpr int none = 1, lzw = 5, old_jpeg = 6, jpeg = 7, deflate = 8, old_deflate = 32946, pack_bits = 32773;
  switch (compression) {
    case none:
      return 1.0;
    case pack_bits:
      return 64.0;
    case lzw:
      return 2731.0;  // 12 bits for 4096
    case deflate:
    case old_deflate:
      return 1032.0;
    case old_jpeg:
    case jpeg:
      return 3 * 512.0;  // a bit for a block of 8 × 8 with three channels
    default:
      return 65536.0;
  }
}

void require_honest_tiff(const OIIO::ImageSpec& spec, std::uint64_t file_size) {
  const double bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(8 * spec.format.basesize()));
  const double bytes = static_cast<double>(spec.image_pixels()) * spec.nchannels * bits / 8.0;
  if (bytes > largest_tiff_ratio(spec.get_int_attribute("tiff:Compression", 1)) * static_cast<double>(file_size))
    throw std::runtime_error("a header that claims more pixels than a file of this size can hold");
}

void require_readable(const OIIO::ImageSpec& spec, std::size_t max_pixels) {
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 || spec.nchannels > 16)
    throw std::runtime_error("not a two-dimensional image of 1 to 16 channels");
  if (spec.image_pixels() > max_pixels)
    throw std::runtime_error("a header that claims " + std::to_string(spec.width) + " x " +
                             std::to_string(spec.height) + " pixels, more than " + std::to_string(max_pixels));
}

void require_rgb(const OIIO::ImageSpec& spec) {
  if (spec.get_string_attribute("tiff:ColorSpace").find("LAB") != std::string::npos)
    throw std::runtime_error("colours in CIELAB, which are not read");
}

/// How many rows are read at once: whole tiles or strips, of about 64 MiB.
int rows_at_once(const OIIO::ImageSpec& spec) {
  constexpr std::size_t bytes = std::size_t{1} << 26;
  const auto row_bytes =
      static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.nchannels) * sizeof(float);
  const int wanted = std::max(1, static_cast<int>(std::min<std::size_t>(bytes / row_bytes, 1 << 20)));
  const int unit = spec.tile_width ? spec.tile_height : std::max(1, spec.get_int_attribute("tiff:RowsPerStrip", 1));
  return std::min(spec.height, (std::max(wanted, unit) / unit) * unit);
}

/// Of what a reader complains about and reads on, only that bytes are missing counts: other programs' JPEG files have
/// stray bytes and markers that do no harm. A TIFF reader says nothing by its result where a strip is broken.
void require_whole(OIIO::ImageInput& input) {
  if (!input.has_error()) return;
  const std::string complaint = input.geterror();
  if (std::string(input.format_name()) != "jpeg" || complaint.find("remature end") != std::string::npos)
    throw std::runtime_error(complaint);
}

/// What the header says of the pixels beyond their values.
void describe(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, sturm_imageformats_pixels* pixels) {
  pixels->orientation = spec.get_int_attribute("Orientation", 1);
  for (const char* name : {"jpeg:ColorSpace", "tiff:ColorSpace", "psd:ColorSpace"}) {
    const std::string space = spec.get_string_attribute(name);
    if (space == "CMYK" || space == "YCbCrK") pixels->was_cmyk = 1;
  }
  if (const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile")) {
    const auto size = static_cast<std::size_t>(profile->datasize());
    pixels->profile = allocate<unsigned char>(size);
    pixels->profile_size = size;
    std::memcpy(pixels->profile, profile->data(), size);
  }
  const std::string format = input.format_name();
  pixels->has_more = (format == "tiff" || format == "gif" || format == "webp") && input.seek_subimage(1, 0);
  static_cast<void>(input.geterror());
}

/// All pixels of an opened file.
void read_opened(OIIO::ImageInput& input, sturm_imageformats_pixels* pixels) {
  const OIIO::ImageSpec spec = input.spec();
  pixels->bits = spec.format.is_floating_point()
                     ? 0
                     : spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(8 * spec.format.basesize()));
  const std::size_t row = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.nchannels);
  const int step = rows_at_once(spec), left = spec.x, right = spec.x + spec.width;
  for (int y = 0; y < spec.height; y += step) {
    const int rows = std::min(step, spec.height - y), top = spec.y + y;
    float* to =
        pixels->room(pixels->owner, row * static_cast<std::size_t>(y + rows)) + row * static_cast<std::size_t>(y);
    const bool read =
        spec.tile_width
            ? input.read_tiles(0, 0, left, right, top, top + rows, 0, 1, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, to)
            : input.read_scanlines(0, 0, top, top + rows, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, to);
    if (!read) throw std::runtime_error(input.geterror());
    require_whole(input);
  }
  pixels->width = spec.width;
  pixels->height = spec.height;
  pixels->channels = spec.nchannels;
  describe(input, spec, pixels);
}

std::unique_ptr<OIIO::ImageInput> reader_of(const char* format) {
  auto input = OIIO::ImageInput::create(format);
  if (!input) throw std::runtime_error(OIIO::geterror());
  return input;
}

}  // namespace

int sturm_imageformats_read(const char* format, const char* path, std::size_t max_pixels,
                            sturm_imageformats_pixels* pixels, char* error, std::size_t error_size) {
  return guarded(error, error_size, [&] {
    const auto input = reader_of(format);
    OIIO::ImageSpec spec;
    if (!input->open(path, spec, values_as_stored())) throw std::runtime_error(input->geterror());
    require_readable(spec, max_pixels);
    if (std::strcmp(format, "tiff") == 0) require_honest_tiff(spec, OIIO::Filesystem::file_size(path));
    require_rgb(spec);
    read_opened(*input, pixels);
  });
}

int sturm_imageformats_read_memory(const char* format, const unsigned char* bytes, std::size_t size,
                                   std::size_t max_pixels, sturm_imageformats_pixels* pixels, char* error,
                                   std::size_t error_size) {
  return guarded(error, error_size, [&] {
    OIIO::Filesystem::IOMemReader memory_file(const_cast<unsigned char*>(bytes), size);  // it only reads
    const auto input = reader_of(format);
    OIIO::ImageSpec spec;
    if (!input->set_ioproxy(&memory_file) || !input->open(std::string("memory.") + format, spec, values_as_stored()))
      throw std::runtime_error(input->geterror());
    require_readable(spec, max_pixels);
    read_opened(*input, pixels);
  });
}

void sturm_imageformats_free(void* memory) {
  std::free(memory);
}
