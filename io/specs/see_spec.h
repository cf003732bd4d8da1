#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/images/depth_map.h"
#include "io/json/json.h"
#include "io/specs/seen_psf.h"
#include "lensmodel/eye.h"

namespace sturm {

/// The eye of one frame of a sequence, or of the only picture.
struct SeeingEye {
  Eye eye;
  double accommodation_D = 0.0;
};

/// A validated document of format sturm.see/1. Files are absolute paths.
struct SeeSpec {
  std::string picture;
  std::optional<std::string> picture_layer;
  std::vector<std::string> layers;                        ///< surfaces that the picture hides
  std::optional<double> distance_m;                       ///< of a flat picture; none: it has depth
  std::optional<std::string> depth_map;                   ///< none: the picture's own
  DepthReading depth_reading;                             ///< of the layers, too
  std::optional<double> vfov_deg, hfov_deg, pixel_slope;  ///< at most one; none: the picture's own
  SeenPsf psf = SeenPsf::Rays;
  int parts = 0;  ///< of the pupil
  bool chromatic = false;
  double exposure = 1.0;  ///< of a PNG
  int png_bits = 8;
  bool sequence = false;          ///< whether there are frames, and not one picture
  std::vector<SeeingEye> frames;  ///< one, or those of the sequence
  std::vector<std::string> notes, input_files;
  std::shared_ptr<const Json> resolved;  ///< with every default spelt out but the width of a pixel
};

/// Validates and reads what is seen by whom; `file` names the document in errors and is where relative paths start.
/// Throws InputError. Pictures are not opened.
SeeSpec read_see_spec(const Json& document, const std::string& file);

}  // namespace sturm
