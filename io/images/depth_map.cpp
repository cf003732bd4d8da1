#include "io/images/depth_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "io/files/text_file.h"
#include "io/images/exr_picture.h"
#include "io/images/image_formats.h"
#include "io/images/png_header.h"
#include "io/images/portable_float_map.h"

namespace sturm {

namespace {

constexpr double hole = -1.0;  // vergence of a pixel without depth

/// What a number says about its pixel, at column x and row y.
double vergence_of_number(double number, DepthUnit unit, const StereoCalibration& stereo, const std::string& name,
                          int x, int y) {
  const auto refuse = [&](const char* expected) {
    throw InputError(
        name, "", std::to_string(number) + " at column " + std::to_string(x) + ", row " + std::to_string(y), expected);
  };
  if (std::isnan(number) || number < 0.0) refuse("a depth that is a number and not negative");
  if (unit == DepthUnit::Dioptres) {
    if (std::isinf(number)) refuse("a finite number of dioptres");
    return number;
  }
  if (number == 0.0) return hole;
  if (unit == DepthUnit::Disparity) {
    if (std::isinf(number)) return hole;
    if (number + stereo.doffs_px < 0.0) refuse("a disparity that is not below zero with doffs added");
    return (number + stereo.doffs_px) / (stereo.focal_px * stereo.baseline_m);
  }
  const double metres = unit == DepthUnit::Millimetres ? 1e-3 * number : number;
  return 1.0 / metres;
}

/// Fills holes ring by ring; a ring sees only what earlier ones have filled, so that the order of visits does not
/// matter.
class HoleFilling {
 public:
  explicit HoleFilling(DepthMap& map) : map_(map), listed_(map.vergence_D.size(), false) {}

  void fill() {
    map_.filled_holes = std::count(map_.vergence_D.begin(), map_.vergence_D.end(), hole);
    if (map_.filled_holes == 0) return;
    std::vector<std::size_t> ring, next;
    for (std::size_t i = 0; i < map_.vergence_D.size(); ++i)
      if (is_hole(i) && farthest_about(i) != hole) {
        listed_[i] = true;
        ring.push_back(i);
      }
    std::vector<double> filled;
    for (; !ring.empty(); std::swap(ring, next)) {
      filled.clear();
      for (const std::size_t i : ring) filled.push_back(farthest_about(i));
      for (std::size_t k = 0; k < ring.size(); ++k) map_.vergence_D[ring[k]] = filled[k];
      next.clear();
      for (const std::size_t i : ring) list_holes_about(i, next);
    }
  }

 private:
  bool is_hole(std::size_t i) const { return map_.vergence_D[i] == hole; }

  template <class Visit>
  void around(std::size_t i, Visit visit) const {
    const int x = static_cast<int>(i % map_.width), y = static_cast<int>(i / map_.width);
    for (int v = std::max(0, y - 1); v <= std::min(map_.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(map_.width - 1, x + 1); ++u)
        visit(static_cast<std::size_t>(v) * map_.width + u);
  }

  void list_holes_about(std::size_t i, std::vector<std::size_t>& ring) {
    around(i, [&](std::size_t j) {
      if (!is_hole(j) || listed_[j]) return;
      listed_[j] = true;
      ring.push_back(j);
    });
  }

  double farthest_about(std::size_t i) const {
    double farthest = hole;
    around(i, [&](std::size_t j) {
      if (!is_hole(j) && (farthest == hole || map_.vergence_D[j] < farthest)) farthest = map_.vergence_D[j];
    });
    return farthest;
  }

  DepthMap& map_;
  std::vector<bool> listed_;  // in a ring
};

Image read_float_map(const std::filesystem::path& path) {
  const std::optional<std::string> bytes = file_contents(path);
  if (!bytes) throw InputError(path.string(), "", "no such file", "a PFM file");
  if (!is_portable_float_map(*bytes)) throw InputError(path.string(), "", "another first word", "PF or Pf");
  try {
    return decode_portable_float_map(*bytes, most_pixels, true);
  } catch (const std::runtime_error& error) {
    throw InputError(path.string(), "", error.what(), "a portable float map");
  }
}

/// The channel of an image that holds numbers: the only one, or all three are equal.
Image one_channel(const Image& image, const std::string& name) {
  Image numbers(image.width, image.height, 1);
  const bool alpha = image.channels == 2 || image.channels == 4;
  const int used = image.channels - (alpha ? 1 : 0);
  for (std::size_t i = 0; i < numbers.pixels.size(); ++i) {
    const float* pixel = &image.pixels[i * static_cast<std::size_t>(image.channels)];
    for (int c = 1; c < used; ++c)
      if (pixel[c] != pixel[0] && !(std::isnan(pixel[c]) && std::isnan(pixel[0])))
        throw InputError(name, "", "a picture in colour", "a depth map: one channel, or equal ones");
    numbers.pixels[i] = pixel[0];
  }
  return numbers;
}

}  // namespace

DepthMap depth_of(const Image& stored, const DepthReading& reading, const std::string& name) {
  const DepthUnit unit = reading.unit.value_or(DepthUnit::Metres);
  DepthMap map{stored.width, stored.height, std::vector<double>(stored.pixels.size()), 0};
  bool any = false;
  for (std::size_t i = 0; i < stored.pixels.size(); ++i) {
    map.vergence_D[i] =
        vergence_of_number(reading.scale.value_or(1.0) * static_cast<double>(stored.pixels[i]), unit, reading.stereo,
                           name, static_cast<int>(i % stored.width), static_cast<int>(i / stored.width));
    any = any || map.vergence_D[i] != hole;
  }
  if (!any) throw InputError(name, "", "no pixel with a depth", "a depth map");
  HoleFilling(map).fill();
  return map;
}

DepthMap read_depth_map(const std::filesystem::path& path, const DepthReading& reading) {
  const std::string suffix = lower_case(path.extension().string());
  if (suffix == ".exr") return depth_of(one_channel(read_exr_depth(path), path.string()), reading, path.string());
  if (suffix == ".pfm") return depth_of(one_channel(read_float_map(path), path.string()), reading, path.string());
  if (suffix != ".png") throw InputError(path.string(), "", "\"" + suffix + "\"", "a depth map as EXR, PFM or PNG");
  Image stored = one_channel(read_image(path), path.string());
  const int bits = png_bit_depth(path).value_or(0);
  if (bits != 16 && !(bits == 8 && reading.unit == DepthUnit::Disparity))
    throw InputError(path.string(), "", std::to_string(bits) + " bits", "16 bits for each pixel of a depth map");
  const float largest = bits == 16 ? 65535.0f : 255.0f;
  for (float& value : stored.pixels) value = std::round(value * largest);
  DepthReading in_file = reading;
  if (!reading.unit && !reading.scale) in_file.unit = DepthUnit::Millimetres;
  return depth_of(stored, in_file, path.string());
}

}  // namespace sturm
