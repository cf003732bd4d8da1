#pragma once
// The layered pictures of tests/reference/planes, computed point by point by another program.
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "io/images/exr.h"
#include "lensmodel/eye.h"
#include "support/reference_file.h"
#include "support/source_folder.h"
#include "wavefront/layers/guessed_background.h"
#include "wavefront/layers/layer_blur.h"
#include "wavefront/layers/ray_kernels.h"

namespace sturm::testing {

/// One channel count of a file: 3 for colours, 1 for numbers.
inline Image plane_image(const std::string& name) {
  LayeredImage file = read_exr(std::filesystem::path(STURM_SOURCE_DIR) / "tests/reference/planes" / (name + ".exr"));
  return file.layers.contains("") ? file.layers.at("") : file.layers.begin()->second;
}

inline std::vector<double> vergences(const Image& depth) {
  std::vector<double> v;
  for (const float d : depth.pixels) v.push_back(1.0 / static_cast<double>(d));
  return v;
}

/// An eye of planes.json with its accommodation [D].
struct PlaneEye {
  Eye eye;
  double accommodation_D;
};

inline PlaneEye plane_eye(const nlohmann::json& planes, const std::string& name) {
  const auto& given = planes["header"]["eyes"][name];
  const double pupil_m = 1e-3 * given["pupil_mm"].get<double>();
  if (given["kind"] == "rx")
    return {Eye::with(Prescription{given["SCA"][0], given["SCA"][1], given["SCA"][2], 0.0}, pupil_m), given["A"]};
  std::vector<double> c(21, 0.0);
  for (const auto& [j, um] : given["um"].items()) c[std::stoul(j)] = 1e-6 * um.get<double>();
  return {Eye::with(ZernikeWave::from_examiner(c, 0.5 * pupil_m), SecondOrder::LeastSquares, std::nullopt, pupil_m),
          given["A"]};
}

inline double plane_pixel(const nlohmann::json& planes) {
  return planes["header"]["pixel_pitch_tangent"];
}

/// The middle `size` × `size` pixels.
inline Image middle(const Image& image, int size) {
  Image part(size, size, image.channels);
  const int left = (image.width - size) / 2, top = (image.height - size) / 2;
  for (int y = 0; y < size; ++y)
    std::copy_n(image.at(left, top + y), static_cast<std::size_t>(size) * image.channels, part.at(0, y));
  return part;
}

inline LayeredPicture plane_picture(const std::string& scene, double jump_D) {
  LayeredPicture picture;
  picture.radiance = plane_image(scene + "_sharp");
  picture.vergence_D = vergences(plane_image(scene + "_depth"));
  picture.jump_D = jump_D;
  return picture;
}

/// A plane of a scene, everywhere at its distance.
inline PictureLayer plane_layer(const std::string& scene, int index, double distance_m, bool has_holes) {
  const std::string number = std::to_string(index);
  PictureLayer layer;
  layer.radiance = plane_image(scene + "_layer" + number);
  layer.vergence_D.assign(layer.radiance.pixels.size() / 3, 1.0 / distance_m);
  if (has_holes) layer.coverage = plane_image(scene + "_coverage" + number).pixels;
  return layer;
}

}  // namespace sturm::testing
