#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/markup/html.h"

namespace sturm {

class ViewerPayload;

/// Point-spread functions of one view that the viewer shows together, on one scale.
struct SpreadGroup {
  struct Spread {
    std::string key, title;
    std::string file;  ///< EXR, relative to the run folder
  };

  std::string title;
  std::optional<Spread> truth;  ///< what the others are held against: their differences from it become layers, too
  std::vector<Spread> spreads;
  std::string quantity;               ///< what the numbers are, in plain text
  std::optional<double> side_arcmin;  ///< of the whole picture, from its left to its right rim
};

/// Gives the groups of one section to the viewer; the place of each on the page, in the same order. Files that
/// are missing, unreadable or of another size than the first are left out; nothing for a group without any. All numbers
/// of a section take 3 MB of the page at most; beyond that they are means over blocks of pixels.
std::vector<Html> spread_viewers(const std::vector<SpreadGroup>& groups, const std::filesystem::path& run_folder,
                                 ViewerPayload& payload);

}  // namespace sturm
