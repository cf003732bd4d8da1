#include "reports/markup/drawing.h"

#include <cstdio>

namespace sturm {

std::string svg_document(int width, int height, const std::string& label, const Html& body) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  const Html ground = empty_element("rect", {{"width", w}, {"height", h}, {"fill", "#fff"}});
  return element("svg",
                 {{"xmlns", "http://www.w3.org/2000/svg"},
                  {"role", "img"},
                  {"aria-label", label},
                  {"viewBox", "0 0 " + w + " " + h},
                  {"width", w},
                  {"height", h},
                  {"font-family", "sans-serif"},
                  {"fill", "#222"}},
                 ground + body)
      .markup();
}

std::string coordinate(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2f", value);
  return buffer;
}

Html white_ground() {
  return empty_element("rect", {{"width", "100%"}, {"height", "100%"}, {"fill", "#ffffff"}}) + "\n"_html;
}

Html svg_text(double x, double y, const std::string& words, const char* anchor, int size, const std::string& colour) {
  Attributes attributes = {
      {"x", coordinate(x)}, {"y", coordinate(y)}, {"text-anchor", anchor}, {"font-size", std::to_string(size)}};
  if (!colour.empty()) attributes.push_back({"fill", colour});
  return element("text", attributes, text(words));
}

}  // namespace sturm
