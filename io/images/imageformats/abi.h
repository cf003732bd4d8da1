#pragma once
#include <cstddef>

/// Plain C interface between the program and its image format module (OpenImageIO), which is opened only when a file
/// needs it. Functions return 0, or 1 with a message in `error`; memory they hand out is given back by
/// sturm_imageformats_free.
extern "C" {

/// Where pixels go. `room` gives room for `count` floats in all; those that were there before stay.
struct sturm_imageformats_pixels {
  void* owner;
  float* (*room)(void* owner, std::size_t count);
  int width = 0, height = 0, channels = 0;
  int bits = 0;                      ///< of integer values, 0 for floats
  int orientation = 1;               ///< as EXIF and TIFF count them, 1 … 8
  int was_cmyk = 0;                  ///< whether the reader has made the colours from those of printers
  int has_more = 0;                  ///< whether the file has further pictures
  unsigned char* profile = nullptr;  ///< ICC, or null; handed out
  std::size_t profile_size = 0;
};

/// Values as stored, 0…1 for integer formats; height × width × channels floats, row 0 at the top. `format` is
/// OpenImageIO's name of the file's format. More than `max_pixels` are refused before there is room for them, and room
/// is made as pixels arrive.
int sturm_imageformats_read(const char* format, const char* path, std::size_t max_pixels,
                            sturm_imageformats_pixels* pixels, char* error, std::size_t error_size);

/// The same of a PNG or JPEG file of `size` bytes in memory.
int sturm_imageformats_read_memory(const char* format, const unsigned char* bytes, std::size_t size,
                                   std::size_t max_pixels, sturm_imageformats_pixels* pixels, char* error,
                                   std::size_t error_size);

void sturm_imageformats_free(void* memory);
}
