#include "io/json/stored.h"
#include "reports/markup/markup.h"
#include "reports/markup/numbers.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

/// A scalar of the provenance as text; "" for what is no scalar.
std::string scalar_html(const Json& value) {
  if (value.is_string()) return text_html(value.get<std::string>());
  if (value.is_number()) return exact_html(number_at(value, ""));
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return "";
}

std::string facts(const Json& provenance) {
  std::string html;
  for (const auto& [name, value] : provenance.items()) {
    std::string words = name;
    for (char& c : words) c = c == '_' ? ' ' : c;
    if (const std::string text = scalar_html(value); !text.empty()) {
      html += element("div", "", element("dt", "", escaped(words)) + element("dd", "", text));
    }
  }
  return html.empty() ? "" : element("dl", "class=\"facts\"", html);
}

std::string input_table(const Json& inputs) {
  if (inputs.empty()) return "";
  HtmlTable table("Input files", "", {{"File", false}, {"SHA-256", false}});
  for (const Json& input : inputs) {
    table.add_row({"<code>" + text_html(text_at(input, "file")) + "</code>",
                   "<code class=\"hash\">" + text_html(text_at(input, "sha256")) + "</code>"});
  }
  return table.html();
}

}  // namespace

std::string provenance_section(const Json& report) {
  const Json& provenance = value_at(report, "provenance");
  const Json& spec = value_at(report, "spec");
  std::string html;
  if (provenance.is_object()) html += facts(provenance) + input_table(array_at(provenance, "inputs"));
  if (!spec.is_null()) {
    html += folded("The experiment with every default spelt out",
                   element("pre", "tabindex=\"0\"", escaped(spec.dump(2, ' ', false, Json::error_handler_t::replace))));
  }
  return html.empty() ? "" : element("section", "id=\"provenance\"", element("h2", "", "Provenance") + html);
}

}  // namespace sturm
