#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/images/image_comparison.h"
#include "io/images/image.h"
#include "reports/markup/html.h"

namespace sturm {

/// What the viewer shows together: pictures and maps of one size, one layer each, in this order. Maps of several
/// pictures take turns: the viewer has those of one picture at a time among its layers.
struct ViewerSet {
  /// Radiance: linear Rec. 709 pictures of three channels, with exposure and tones. Density: pictures of one channel ≥
  /// 0 in false colour, linear or logarithmic, on one scale for the whole set.
  enum class Kind { Radiance, Density };

  struct Picture {
    std::string key, title;
    std::string file;  ///< under which it was added
  };

  struct Map {
    /// Signed: white at 0, its colours end at ±`end`. Error: from 0 to `end`. Similarity: from 1 down to 1 − `end`.
    enum class Scale { Signed, Error, Similarity };
    std::string key, title;
    Image values;  ///< one channel, before shrinking; NaN: no value there
    double end;    ///< > 0
    Scale scale;
    std::string of{};  ///< key of the picture whose errors these are; "": of the set's only prediction
  };

  std::string title;
  Kind kind = Kind::Radiance;
  std::vector<Picture> pictures;  ///< not empty; split and side by side begin with the first two
  std::vector<Map> maps;
  int factor = 1;  ///< by which the pictures were shrunk, and the maps will be

  std::string quantity;  ///< what the numbers are, in plain text
  double peak = 0.0;     ///< of a density: what has the lightest colour
  std::optional<double>
      pixel_arcmin;  ///< of a density: side of a pixel before shrinking; positions count from the picture's middle
};

/// What a page's image viewer is given: linear values and error maps as 16-bit floats, and the colours of the maps. A
/// picture that several sets show is stored once. The viewer itself is reports/viewer/assets/viewer*.js.
class ViewerPayload {
 public:
  /// Stores a picture under its file name, once; `factor` ≥ 1: means over blocks of that many pixels squared. One
  /// channel (a density) is stored times a power of two that brings it well within the range of 16-bit floats.
  void add_picture(const std::string& file, const Image& linear, int factor);

  /// A set for the viewer; its pictures were added. Returns its number.
  std::size_t add_set(const ViewerSet& shown);

  /// The payload as a <script> of type application/json with the id "viewer-payload"; nothing without a set.
  Html html() const;

 private:
  std::map<std::string, std::string> pictures_;  ///< JSON text by file name
  std::vector<std::string> sets_;                ///< JSON texts
};

/// Where the page's script puts the viewer of the payload's set of this number.
Html viewer_place(std::size_t number);

/// What the numbers of a set of pictures in linear light are.
inline constexpr const char* viewer_radiance = "pictures in linear Rec. 709 radiance, maps at exposure 0";

/// Keys of the metrics whose maps the viewer shows, in its order.
const std::vector<std::string>& viewer_maps();

/// The signed difference of the luma in display space of a prediction from path tracing (its colours end at
/// ±`difference_limit`), and the maps of `metrics` that the viewer shows; no more than `most` ≥ 1.
std::vector<ViewerSet::Map> maps_of_images(const Image& difference, double difference_limit,
                                           const std::vector<ImageMetric>& metrics, std::size_t most);

}  // namespace sturm
