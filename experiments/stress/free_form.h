#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "lensmodel/spectacles.h"

namespace sturm::stress {

/// The lenses of the suite that have a B-spline surface: progressive fronts of every kind that the maker knows, on
/// knots from fine to coarse, and backs through a table of heights: a torus (oblique, strong), one whose table ends
/// before the rim, one with ripples. Made once and shared by all cases.
class FreeFormLenses {
 public:
  static constexpr int count = 9;
  FreeFormLenses();

  /// Lens number k; a case gives it its own vertex distance and mounting.
  const Spectacles& lens(int k) const { return made_.at(static_cast<std::size_t>(k)).lens; }

  /// As a spectacles document, with the members of `stands` (vertex distance, mounting) in their place.
  Json document(int k, const Json& stands) const;

  /// The table that the document names, none for a progressive lens: file name and text.
  struct Table {
    std::string file, text;
  };
  const std::optional<Table>& table(int k) const { return made_.at(static_cast<std::size_t>(k)).table; }

 private:
  struct Made {
    std::string document;  ///< JSON text
    Spectacles lens;
    std::optional<Table> table;
  };
  static Made with_table(const char* name, int cells, double spacing_mm, double (*height_mm)(double x_mm, double y_mm));
  std::vector<Made> made_;
};

}  // namespace sturm::stress
