#include <algorithm>

#include "io/json/stored.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

Html ray_facts(const Json& conditions) {
  const auto count = number_at(conditions, "rays_per_replicate"), replicates = number_at(conditions, "replicates");
  if (!count || !replicates) return {};
  Html html = count_html(replicates) + " × "_html + count_html(count);
  for (const char* key : {"sequence", "sampling"}) {
    std::string words = text_at(conditions, key);
    std::replace(words.begin(), words.end(), '_', ' ');
    if (!words.empty()) html += ", "_html + text(words);
  }
  return html;
}

Html time_facts(const Json& provenance) {
  Html html = duration_html(number_at(provenance, "seconds/total"));
  Html parts;
  const Json& seconds = value_at(provenance, "seconds");
  if (seconds.is_object()) {
    for (const auto& [part, time] : seconds.items()) {
      if (part == "total") continue;
      add_item(parts, text(part) + " "_html + duration_html(number_at(time, "")));
    }
  }
  return parts.empty() ? html : html + small_html(parts);
}

Html conditions(const Json& report) {
  const Json& provenance = value_at(report, "provenance");
  std::string machine = text_at(provenance, "cpu");
  if (const std::string set = text_at(provenance, "instruction_set"); !set.empty()) machine += " (" + set + ")";
  const std::string version = text_at(provenance, "version"), commit = text_at(provenance, "commit");
  return fact_list(fact("Seed", exact_html(number_at(provenance, "seed"))) +
                   fact("Rays per case and model", ray_facts(value_at(report, "ellipses/conditions"))) +
                   fact("Time", time_facts(provenance)) +
                   fact("Threads", exact_html(number_at(provenance, "threads"))) + fact("Machine", text(machine)) +
                   fact("Version", (version.empty() ? Html() : text(version + " · ")) +
                                       (commit.empty() ? Html() : code_html(commit))) +
                   fact("Started (UTC)", text_or_dash(text_at(provenance, "started_utc"))));
}

}  // namespace

Html verdict_section(const Json& report) {
  const auto passed = boolean_at(report, "verdict/passed");
  const Html word = !passed ? "No verdict"_html : *passed ? "Passed"_html : "Failed"_html;
  const std::string css_class = !passed ? "unknown" : *passed ? "pass" : "fail";
  const Html banner = element("p", {{"class", "word"}}, word) +
                      element("p", {{"class", "sentence"}}, text_or_dash(text_at(report, "verdict/sentence")));
  Html html = element("p", {{"class", "kind"}}, "Sturm: path-traced against predicted blur of an astigmatic eye"_html) +
              element("h1", text_or_dash(text_at(report, "title"))) +
              element("div", {{"class", "verdict " + css_class}, {"role", "status"}}, banner);
  if (const std::string sentence = text_at(report, "verdict/sin2_sentence"); !sentence.empty()) {
    html += element("div", {{"class", "finding"}},
                    element("h2", "What was measured of sin²"_html) + element("p", text(sentence)));
  }
  if (const std::string sentence = text_at(report, "verdict/lens_sentence"); !sentence.empty()) {
    html += element("div", {{"class", "finding"}},
                    element("h2", "What was measured of conoid tracing"_html) + element("p", text(sentence)));
  }
  if (const std::string sentence = text_at(report, "verdict/sin2_study_sentence"); !sentence.empty())
    html += element("div", {{"class", "finding"}},
                    element("h2", "The verdict on sin²"_html) + element("p", text(sentence)));
  return element("header", {{"id", "verdict"}}, html + conditions(report));
}

}  // namespace sturm
