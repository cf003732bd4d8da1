#pragma once
#include <string>

#include "reports/markup/html.h"

namespace sturm {

/// A whole SVG document of a drawing that this program makes itself: white ground, plain sans-serif letters, so that it
/// looks the same in a report, in a browser and on paper. `label` says what it shows for those who cannot see it (plain
/// text).
std::string svg_document(int width, int height, const std::string& label, const Html& body);

/// `value` with two decimals, for coordinates.
std::string coordinate(double value);

/// A white ground as large as the drawing.
Html white_ground();

/// Plain text at (x, y); `anchor` is start, middle or end; `size` in pixels; `colour` "" is the drawing's own.
Html svg_text(double x, double y, const std::string& words, const char* anchor = "middle", int size = 13,
              const std::string& colour = "");

}  // namespace sturm
