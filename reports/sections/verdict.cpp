#include "compare/gates/verdict.h"

#include <algorithm>

#include "compare/findings/ellipses.h"
#include "io/json/stored.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

Html ray_facts(const EllipseConditions& conditions) {
  if (!conditions.rays_per_replicate || !conditions.replicates) return {};
  Html html = count_html(conditions.replicates) + " × "_html + count_html(conditions.rays_per_replicate);
  for (std::string words : {conditions.sequence, conditions.sampling}) {
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
                   fact("Rays per case and model", ray_facts(read_ellipses(report).conditions)) +
                   fact("Time", time_facts(provenance)) +
                   fact("Threads", exact_html(number_at(provenance, "threads"))) + fact("Machine", text(machine)) +
                   fact("Version", (version.empty() ? Html() : text(version + " · ")) +
                                       (commit.empty() ? Html() : code_html(commit))) +
                   fact("Started (UTC)", text_or_dash(text_at(provenance, "started_utc"))));
}

}  // namespace

Html verdict_section(const Json& report) {
  const Verdict verdict = read_verdict(report);
  const Html word = !verdict.passed ? "No verdict"_html : *verdict.passed ? "Passed"_html : "Failed"_html;
  const std::string css_class = !verdict.passed ? "unknown" : *verdict.passed ? "pass" : "fail";
  const Html banner =
      element("p", {{"class", "word"}}, word) + element("p", {{"class", "sentence"}}, text_or_dash(verdict.sentence));
  Html html = element("p", {{"class", "kind"}}, "Sturm: path-traced against predicted blur of an astigmatic eye"_html) +
              element("h1", text_or_dash(text_at(report, "title"))) +
              element("div", {{"class", "verdict " + css_class}, {"role", "status"}}, banner);
  const auto add_finding = [&](const char* key, const Html& heading) {
    if (const std::string sentence = verdict.finding(key); !sentence.empty())
      html += element("div", {{"class", "finding"}}, element("h2", heading) + element("p", text(sentence)));
  };
  add_finding("sin2_sentence", "What was measured of sin²"_html);
  add_finding("lens_sentence", "What was measured of conoid tracing"_html);
  add_finding("sin2_study_sentence", "The verdict on sin²"_html);
  return element("header", {{"id", "verdict"}}, html + conditions(report));
}

}  // namespace sturm
