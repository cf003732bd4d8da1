#pragma once
#include <filesystem>
#include <vector>

#include "compare/findings/pictures.h"
#include "reports/markup/html.h"

namespace sturm {

class ViewerPayload;

/// What the page shows of the pictures of one finding.
struct PictureBlock {
  Html html;             ///< a place of the viewer and stills, or a sentence why there are none
  int still_factor = 1;  ///< side of the blocks of pixels that the stills' pixels are means of
};

struct PictureBlocks {
  std::vector<PictureBlock> blocks;  ///< in the order of the findings
  double error_limit = 1.0;          ///< ± end of the colours of all differences (luma in display space)
};

/// The pictures of all findings of a report, on one scale of errors: a place of the viewer (path traced, every
/// prediction, and the error maps of one prediction at a time), and stills of path traced, predicted and their
/// difference for where there are no scripts and for print. A sentence instead where files are missing or differ in
/// size.
///
/// The viewer's numbers of all of them together take 18.5 MB of the page at most. Beyond that the last maps are left
/// out, down to the difference, SSIM and FLIP, and then pictures and maps become means over blocks of pixels. Stills
/// take 5.5 MB at most.
PictureBlocks picture_blocks(const std::vector<PictureFinding>& findings, const std::filesystem::path& run_folder,
                             ViewerPayload& payload);

}  // namespace sturm
