#include "reports/markup/drawing.h"

#include <cstdio>

#include "reports/markup/markup.h"

namespace sturm {

std::string svg_document(int width, int height, const std::string& label, const std::string& body) {
  const std::string size = std::to_string(width) + "\" height=\"" + std::to_string(height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"" + escaped(label) + "\" viewBox=\"0 0 " +
         std::to_string(width) + " " + std::to_string(height) + "\" width=\"" + size +
         "\" font-family=\"sans-serif\" fill=\"#222\"><rect width=\"" + size + "\" fill=\"#fff\"/>" + body + "</svg>\n";
}

std::string coordinate(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2f", value);
  return buffer;
}

std::string svg_text(double x, double y, const std::string& text, const char* anchor, int size,
                     const std::string& colour) {
  return "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" text-anchor=\"" + anchor + "\" font-size=\"" +
         std::to_string(size) + "\"" + (colour.empty() ? "" : " fill=\"" + colour + "\"") + ">" + escaped(text) +
         "</text>\n";
}

}  // namespace sturm
