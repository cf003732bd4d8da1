#pragma once
#include <filesystem>
#include <vector>

#include "io/json/json.h"
#include "reports/markup/html.h"

namespace sturm {

class ViewerPayload;

/// The pictures of each entry of a report's section "agreement": a place of the viewer (path traced, every prediction,
/// and the error maps of one prediction at a time), and stills of path traced, predicted and their difference for where
/// there are no scripts and for print. In the order of the entries; a sentence instead where files are missing
/// or differ in size.
///
/// The viewer's numbers of all entries together take 18.5 MB of the page at most. Beyond that the last maps are left
/// out, down to the difference, SSIM and FLIP, and then pictures and maps become means over blocks of pixels. Stills
/// take 5.5 MB at most.
std::vector<Html> agreement_pictures(const Json& entries, const std::filesystem::path& run_folder,
                                     ViewerPayload& payload);

}  // namespace sturm
