#include "compare/gates/verdict.h"

#include <nlohmann/json.hpp>

#include "io/json/stored.h"

namespace sturm {

namespace {

constexpr const char* ending_of_findings = "_sentence";

}  // namespace

std::string Verdict::finding(const std::string& key) const {
  const auto found = findings.find(key);
  return found == findings.end() ? "" : found->second.value_or("");
}

Verdict verdict_of(std::span<const GateResult> results) {
  if (results.empty()) return {.passed = std::nullopt, .sentence = "No gates: nothing was judged.", .findings = {}};
  std::size_t passed = 0;
  std::string failed;
  for (const GateResult& result : results) {
    if (result.has_passed())
      ++passed;
    else
      failed += (failed.empty() ? "" : ", ") + result.id + (result.cases == 0u ? " (no case)" : "");
  }
  const std::string total = std::to_string(passed) + " of " + std::to_string(results.size()) + " gates passed";
  return {.passed = passed == results.size(),
          .sentence = total + (failed.empty() ? "." : "; failed: " + failed + "."),
          .findings = {}};
}

Json to_json(const Verdict& verdict) {
  Json json = {{"passed", verdict.passed ? Json(*verdict.passed) : Json(nullptr)}, {"sentence", verdict.sentence}};
  for (const auto& [key, sentence] : verdict.findings) json[key] = sentence ? Json(*sentence) : Json(nullptr);
  return json;
}

Verdict read_verdict(const Json& report) {
  const Json& section = value_at(report, "verdict");
  Verdict verdict{.passed = boolean_at(section, "passed"), .sentence = text_at(section, "sentence"), .findings = {}};
  if (section.is_object())
    for (const auto& [key, sentence] : section.items())
      if (key.ends_with(ending_of_findings))
        verdict.findings[key] = sentence.is_string() ? std::optional(sentence.get<std::string>()) : std::nullopt;
  return verdict;
}

}  // namespace sturm
