#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/json/json.h"
#include "reports/markup/html.h"

namespace sturm {

/// A picture of a report that has a file of its own.
struct Figure {
  std::string id;       ///< fit for a file name, unique in the report
  std::string section;  ///< id of the report section that shows it; "": the section "Figures"
  std::string title, caption;
  std::string command;  ///< that draws it; "" where the run itself did
  std::string svg;      ///< a whole SVG file
};

/// Path of a figure's file in the run folder.
std::string figure_file(const std::string& id);

/// Its entry in the report's list "figures".
Json figure_json(const Figure& figure);

/// Whether a text is an SVG file that a page can show as a picture: an <svg> element in SVG's namespace.
bool is_svg_file(std::string_view text);

/// An entry of the report's list "figures" on the page. The picture stands in the page as a data address, so that
/// neither styles nor ids nor scripts of the file can reach the page. A file that cannot be read leaves a note.
Html figure_html(const Json& figure, const std::filesystem::path& run_folder);

/// The report's figures that belong to `section` ("": to none), in their order.
std::vector<Json> figures_of(const Json& report, std::string_view section);

}  // namespace sturm
