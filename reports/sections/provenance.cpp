#include "compare/findings/stored_run.h"
#include "io/json/json_text.h"
#include "io/json/stored.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

/// A scalar of the provenance as text; "" for what is no scalar.
Html scalar_html(const Json& value) {
  if (value.is_string()) return text_or_dash(value.get<std::string>());
  if (value.is_number()) return exact_html(number_at(value, ""));
  if (value.is_boolean()) return value.get<bool>() ? "yes"_html : "no"_html;
  return {};
}

Html facts(const Json& provenance) {
  Html html;
  for (const auto& [name, value] : provenance.items()) {
    std::string words = name;
    for (char& c : words) c = c == '_' ? ' ' : c;
    if (const Html known = scalar_html(value); !known.empty())
      html += element("div", element("dt", text(words)) + element("dd", known));
  }
  return html.empty() ? Html() : fact_list(html);
}

Html input_table(const std::vector<StoredInput>& inputs) {
  if (inputs.empty()) return {};
  HtmlTable table("Input files", "", {{"File"_html, false}, {"SHA-256"_html, false}});
  for (const StoredInput& input : inputs)
    table.add_row({code_html(input.file), inline_element("code", {{"class", "hash"}}, text_or_dash(input.sha256))});
  return table.html();
}

}  // namespace

Html provenance_section(const Json& report) {
  const Json& provenance = value_at(report, "provenance");
  const Json& spec = value_at(report, "spec");
  Html html;
  if (provenance.is_object()) html += facts(provenance) + input_table(read_stored_run(report).inputs);
  if (!spec.is_null()) {
    html += folded("The experiment with every default spelt out"_html,
                   element("pre", {{"tabindex", "0"}}, text(json_text(spec, 2))));
  }
  return html.empty() ? Html() : element("section", {{"id", "provenance"}}, element("h2", "Provenance"_html) + html);
}

}  // namespace sturm
