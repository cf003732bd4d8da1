#include <algorithm>

#include "io/json/stored.h"
#include "reports/markup/markup.h"
#include "reports/markup/numbers.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

std::string fact(std::string_view name, const std::string& html) {
  return html.empty() || html == "–" ? "" : element("div", "", element("dt", "", name) + element("dd", "", html));
}

std::string ray_facts(const Json& conditions) {
  const auto count = number_at(conditions, "rays_per_replicate"), replicates = number_at(conditions, "replicates");
  if (!count || !replicates) return "";
  std::string html = count_html(replicates) + " × " + count_html(count);
  for (const char* key : {"sequence", "sampling"}) {
    std::string text = text_at(conditions, key);
    std::replace(text.begin(), text.end(), '_', ' ');
    if (!text.empty()) html += ", " + escaped(text);
  }
  return html;
}

std::string time_facts(const Json& provenance) {
  std::string html = duration_html(number_at(provenance, "seconds/total"));
  std::string parts;
  const Json& seconds = value_at(provenance, "seconds");
  if (seconds.is_object()) {
    for (const auto& [part, time] : seconds.items()) {
      if (part == "total") continue;
      parts.append(parts.empty() ? "" : ", ")
          .append(escaped(part))
          .append(" ")
          .append(duration_html(number_at(time, "")));
    }
  }
  return parts.empty() ? html : html + "<small>" + parts + "</small>";
}

std::string conditions(const Json& report) {
  const Json& provenance = value_at(report, "provenance");
  std::string machine = escaped(text_at(provenance, "cpu"));
  if (const std::string set = text_at(provenance, "instruction_set"); !set.empty())
    machine += " (" + escaped(set) + ")";
  const std::string version = text_at(provenance, "version");
  std::string commit = escaped(text_at(provenance, "commit"));
  if (!commit.empty()) commit = "<code>" + commit + "</code>";
  return element("dl", "class=\"facts\"",
                 fact("Seed", exact_html(number_at(provenance, "seed"))) +
                     fact("Rays per case and model", ray_facts(value_at(report, "ellipses/conditions"))) +
                     fact("Time", time_facts(provenance)) +
                     fact("Threads", exact_html(number_at(provenance, "threads"))) + fact("Machine", machine) +
                     fact("Version", (version.empty() ? "" : escaped(version) + " · ") + commit) +
                     fact("Started (UTC)", text_html(text_at(provenance, "started_utc"))));
}

}  // namespace

std::string verdict_section(const Json& report) {
  const auto passed = boolean_at(report, "verdict/passed");
  const std::string word = !passed ? "No verdict" : *passed ? "Passed" : "Failed";
  const std::string css_class = !passed ? "unknown" : *passed ? "pass" : "fail";
  std::string banner = element("p", "class=\"word\"", word) +
                       element("p", "class=\"sentence\"", text_html(text_at(report, "verdict/sentence")));
  std::string html = element("p", "class=\"kind\"", "Sturm: path-traced against predicted blur of an astigmatic eye") +
                     element("h1", "", text_html(text_at(report, "title"))) +
                     element("div", "class=\"verdict " + css_class + "\" role=\"status\"", banner);
  if (const std::string sentence = text_at(report, "verdict/sin2_sentence"); !sentence.empty()) {
    html += element("div", "class=\"finding\"",
                    element("h2", "", "What was measured of sin²") + element("p", "", escaped(sentence)));
  }
  if (const std::string sentence = text_at(report, "verdict/lens_sentence"); !sentence.empty()) {
    html += element("div", "class=\"finding\"",
                    element("h2", "", "What was measured of conoid tracing") + element("p", "", escaped(sentence)));
  }
  if (const std::string sentence = text_at(report, "verdict/sin2_study_sentence"); !sentence.empty())
    html += element("div", "class=\"finding\"",
                    element("h2", "", "The verdict on sin²") + element("p", "", escaped(sentence)));
  return element("header", "id=\"verdict\"", html + conditions(report));
}

}  // namespace sturm
