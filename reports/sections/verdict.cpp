#include "compare/gates/verdict.h"

#include <algorithm>

#include "compare/findings/ellipses.h"
#include "compare/findings/stored_run.h"
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

Html time_facts(const StoredRun& run) {
  Html html = duration_html(run.total_seconds());
  Html parts;
  for (const auto& [part, time] : run.seconds)
    if (part != "total") add_item(parts, text(part) + " "_html + duration_html(time));
  return parts.empty() ? html : html + small_html(parts);
}

Html conditions(const Json& report) {
  const StoredRun run = read_stored_run(report);
  const std::string machine = run.cpu + (run.instruction_set.empty() ? "" : " (" + run.instruction_set + ")");
  return fact_list(fact("Seed", exact_html(run.seed)) +
                   fact("Rays per case and model", ray_facts(read_ellipses(report).conditions)) +
                   fact("Time", time_facts(run)) + fact("Threads", exact_html(run.threads)) +
                   fact("Machine", text(machine)) +
                   fact("Version", (run.version.empty() ? Html() : text(run.version + " · ")) +
                                       (run.commit.empty() ? Html() : code_html(run.commit))) +
                   fact("Started (UTC)", text_or_dash(run.started_utc)));
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
  for (const ReportSection& section : report_sections()) {
    if (!section.sentence_key) continue;
    if (const std::string sentence = verdict.finding(section.sentence_key); !sentence.empty())
      html += element("div", {{"class", "finding"}},
                      element("h2", text(section.sentence_heading)) + element("p", text(sentence)));
  }
  return element("header", {{"id", "verdict"}}, html + conditions(report));
}

}  // namespace sturm
