#include "reports/sections/command.h"

#include "io/files/formatted_text.h"
#include "io/json/stored.h"
#include "reports/markup/html.h"

namespace sturm {

Html made_by(const Json& report) {
  const std::string experiment = text_at(report, "provenance/inputs/0/file");
  if (experiment.empty()) return {};
  std::string command = "sturm run " + experiment;
  if (const auto seed = number_at(report, "provenance/seed")) command += " --seed " + plain_number(*seed, 15);
  return element("p", {{"class", "made-by"}}, "Made by: "_html + inline_element("code", text(command)));
}

}  // namespace sturm
