#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "compare/images/picture_comparison.h"
#include "compare/metrics/slanted_edge.h"
#include "compare/psf/psf_comparison.h"
#include "io/images/picture_file.h"
#include "io/json/json.h"
#include "stages/picture_view.h"

namespace sturm {

/// MTF of one edge in both pictures.
struct EdgeComparison {
  EdgeMtf test, reference;
};

/// What a file says of its picture.
struct ComparedFile {
  PixelValues values = PixelValues::Linear;
  std::string layer;  ///< of an EXR; "" is the main one
};

/// Everything that `sturm compare` finds.
struct Comparison {
  ComparedFile test_file, reference_file;
  std::vector<std::string> notes;  ///< what was chosen, decoded or left out on reading
  ImageMetricSettings settings;
  PictureComparison pictures;
  std::optional<std::string> regions_note;  ///< what regions could not be told, and why
  std::optional<EdgeComparison> edge;
  std::optional<PsfComparison> psf;
  std::map<std::string, double> bounds;  ///< by key of the metric

  /// Whether the metric on the whole picture keeps its bound. A similarity that is infinite (PSNR of equal pictures)
  /// keeps any, another metric without a value none.
  bool keeps_bound(const std::string& key) const;
  bool passed() const;
};

/// Reads the pictures and measures them. Throws InputError.
Comparison compare_files(const CompareOptions& options);

/// As sturm.comparison/1.
Json json_of(const Comparison& comparison, const CompareOptions& options);

/// The table of `sturm compare`.
std::string table_of(const Comparison& comparison);

/// One PNG in false colour for each metric's map, named by its key, and `scales.json` that says what the colours mean.
void write_maps(const Comparison& comparison, const std::string& folder);

}  // namespace sturm
