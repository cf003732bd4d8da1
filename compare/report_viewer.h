#pragma once
#include <map>
#include <string>
#include <vector>

#include "compare/image_comparison.h"
#include "io/image.h"

namespace sturm {

/// What a page's image viewer is given: linear values and error maps as 16-bit floats, and the colours of the maps. A picture that several
/// cases show is stored once. The viewer itself is compare/report_assets/viewer*.js.
class ViewerPayload {
 public:
  /// Stores a picture under its file name, once; `factor` ≥ 1: means over blocks of that many pixels squared.
  void add_picture(const std::string& file, const Image& linear, int factor);

  /// A case of the viewer: two pictures that were added, the signed difference of their luma in display space (white at 0, its colours end
  /// at ±`difference_limit`), and the maps of `metrics` that the viewer shows. Returns its number.
  std::size_t add_case(const std::string& title, const std::string& path_traced_file, const std::string& predicted_file,
                       const Image& difference, double difference_limit, const std::vector<ImageMetric>& metrics, int factor);

  /// The payload as a <script> of type application/json with the id "viewer-payload"; "" without a case.
  std::string html() const;

 private:
  std::map<std::string, std::string> pictures_;  ///< JSON text by file name
  std::vector<std::string> cases_;               ///< JSON texts
};

/// Keys of the metrics whose maps the viewer shows, in its order.
const std::vector<std::string>& viewer_maps();

}  // namespace sturm
