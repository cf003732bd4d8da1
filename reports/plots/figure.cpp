#include "reports/plots/figure.h"

#include <nlohmann/json.hpp>

#include "io/files/text_file.h"
#include "io/json/stored.h"
#include "reports/markup/parts.h"
#include "reports/markup/pictures.h"

namespace sturm {

std::string figure_file(const std::string& id) {
  return "figures/" + id + ".svg";
}

Json figure_json(const Figure& figure) {
  return {{"id", figure.id},           {"section", figure.section.empty() ? Json(nullptr) : Json(figure.section)},
          {"title", figure.title},     {"caption", figure.caption},
          {"command", figure.command}, {"file", figure_file(figure.id)}};
}

bool is_svg_file(std::string_view text) {
  const std::size_t element = text.find("<svg");
  if (element == std::string_view::npos || text.find("</svg>", element) == std::string_view::npos) return false;
  const std::string_view tag = text.substr(element, text.find('>', element) - element);
  return tag.find("\"http://www.w3.org/2000/svg\"") != std::string_view::npos ||
         tag.find("'http://www.w3.org/2000/svg'") != std::string_view::npos;
}

Html figure_html(const Json& figure, const std::filesystem::path& run_folder) {
  const std::string title = text_at(figure, "title"), name = text_at(figure, "file");
  const auto svg = file_contents(run_folder / name);
  Html html = element("h3", text_or_dash(title));
  if (svg && is_svg_file(*svg)) {
    const std::string address = "data:image/svg+xml;base64," + base64({svg->begin(), svg->end()});
    html += empty_element("img", {{"class", "figure"}, {"alt", title}, {"src", address}}) + "\n"_html;
  } else {
    html +=
        missing_html("No picture: "_html + text(name) + (svg ? " is not an SVG file."_html : " is not there."_html));
  }
  Html caption = text(text_at(figure, "caption")) + small_html("File: "_html + inline_element("code", text(name)));
  if (const std::string command = text_at(figure, "command"); !command.empty())
    caption += small_html("Drawn by: "_html + inline_element("code", text(command)));
  return element("figure", html + element("figcaption", caption));
}

std::vector<Json> figures_of(const Json& report, std::string_view section) {
  std::vector<Json> figures;
  for (const Json& figure : array_at(report, "figures"))
    if (text_at(figure, "section") == section) figures.push_back(figure);
  return figures;
}

}  // namespace sturm
