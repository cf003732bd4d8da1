#include "reports/viewer/html_page.h"

#include <stdexcept>
#include <utility>
#include <vector>

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

std::string html_page(std::string_view title, const Html& body) {
  const Html head = empty_element("meta", {{"charset", "utf-8"}}) + "\n"_html +
                    empty_element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}) +
                    "\n"_html + element("title", text(title)) + element("style", Html::trusted(asset("report.css")));
  const Html page = element(
      "html", {{"lang", "en"}},
      element("head", head) + element("body", element("main", body) + element("script", Html::trusted(script()))));
  return "<!DOCTYPE html>\n" + page.markup();
}

}  // namespace sturm
