#include "reports/viewer/html_page.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include "reports/markup/markup.h"

namespace sturm {

/// Generated from reports/viewer/assets by the build.
const std::vector<std::pair<std::string_view, std::string_view>>& embedded_report_assets();

namespace {

std::string asset(std::string_view name) {
  for (const auto& [file, text] : embedded_report_assets()) {
    if (file == name) return std::string(text);
  }
  throw std::logic_error("the report's " + std::string(name) + " was not compiled in");
}

/// The parts of the page's script: one scope for all, so that functions may be used before their file; page.js starts
/// everything.
constexpr const char* scripts[] = {"tables.js",         "payload.js",      "tone.js",
                                   "viewpoint.js",      "viewer.js",       "viewer_panel.js",
                                   "viewer_readout.js", "viewer_input.js", "page.js"};

/// In a CDATA section, whose marks are comments to JavaScript: so the page is well-formed XML, too.
std::string script() {
  std::string text = "//<![CDATA[\n(function () {\n\"use strict\";\n";
  for (const char* file : scripts) text += asset(file);
  return text + "})();\n//]]>";
}

}  // namespace

std::string html_page(std::string_view title, std::string_view body_html) {
  const std::string head =
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
      element("title", "", escaped(title)) + element("style", "", asset("report.css"));
  return "<!DOCTYPE html>\n" +
         element("html", "lang=\"en\"",
                 element("head", "", head) +
                     element("body", "", element("main", "", body_html) + element("script", "", script())));
}

}  // namespace sturm
