#include "app/compare_suite.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/comparison.h"
#include "compare/statistics/test_family.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

/// The one file of a folder with this stem; none if there is none. The PNG beside an EXR file is its preview, as
/// `sturm render` writes it.
std::optional<std::string> picture_in(const fs::path& folder, const std::string& stem) {
  std::optional<std::string> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().stem() != stem || !entry.is_regular_file() || entry.path().extension() == ".json") continue;
    if (entry.path().extension() == ".png" && fs::exists(folder / (stem + ".exr"))) continue;
    if (found) throw InputError(folder.string(), "", "two files named " + stem, "one");
    found = entry.path().string();
  }
  return found;
}

/// Bounds of the pair's own as --bound has them.
std::vector<std::string> bounds_in(const fs::path& file) {
  std::vector<std::string> bounds;
  if (!fs::exists(file)) return bounds;
  const Json document = load_json(file.string());
  if (!document.is_object()) Source{file.string(), ""}.fail(document, "an object of metrics with their bounds");
  for (const auto& [metric, bound] : document.items()) {
    if (!bound.is_number()) (Source{file.string(), ""} / metric).fail(bound, "a number");
    bounds.push_back(metric + "=" + exact_number(bound.get<double>()));
  }
  return bounds;
}

std::optional<SuitePair> pair_in(const fs::path& folder, const CompareOptions& options) {
  const auto test = picture_in(folder, "test"), reference = picture_in(folder, "reference");
  if (!test && !reference) return std::nullopt;
  if (!test || !reference)
    throw InputError(folder.string(), "", test ? "a test alone" : "a reference alone", "test.EXT and reference.EXT");
  SuitePair pair{folder.filename().string(), options};
  pair.options.test = *test;
  pair.options.reference = *reference;
  const auto test_seed = picture_in(folder, "test_seed"), reference_seed = picture_in(folder, "reference_seed");
  if (reference_seed && !test_seed)
    throw InputError(folder.string(), "", "reference_seed without test_seed", "test_seed.EXT");
  if (test_seed) pair.options.noise.push_back(*test_seed);
  if (reference_seed) pair.options.noise.push_back(*reference_seed);
  const std::vector<std::string> own = bounds_in(folder / "bounds.json");
  pair.options.bounds.insert(pair.options.bounds.end(), own.begin(), own.end());
  return pair;
}

bool has_bounds(const CompareOptions& options) {
  return !options.bounds.empty() || options.min_ssim || options.min_psnr_dB || options.max_rmse ||
         options.max_relative_mse;
}

GateResult bound_result(const SuitePair& pair, const Comparison& comparison, const ImageMetric& metric, double bound) {
  GateResult result;
  result.id = pair.name + "/" + metric.key;
  result.title = pair.name + ": " + metric.title;
  result.statistic = metric.key;
  result.kind = metric.more_is_better ? GateKind::AtLeast : GateKind::AtMost;
  result.passed = comparison.keeps_bound(metric.key);
  result.value = metric.value;
  result.bound = bound;
  result.worst_case = pair.options.test;
  result.reason = "bound of the suite or of " + pair.name + "/bounds.json";
  return result;
}

/// The largest z of a pair, still without its threshold.
GateResult noise_result(const SuitePair& pair, const Comparison& comparison, TestFamily& family) {
  GateResult result;
  result.id = pair.name + "/beyond_noise";
  result.title = pair.name + ": largest z against the noise between seeds";
  result.statistic = "largest_z";
  result.kind = GateKind::AtMost;
  result.reason = "nothing may differ by more than seeds do";
  const PartResult& whole = comparison.pictures.parts.front();
  for (std::size_t i = 0; i < whole.metrics.size(); ++i) {
    const auto& noise = whole.metrics[i].noise;
    if (!noise || !noise->z) continue;
    const std::string& key = comparison.pictures.metrics[i].key;
    family.add(result.id + " " + key, *noise->z);
    if (!result.value || *noise->z > *result.value) {
      result.value = *noise->z;
      result.worst_case = key;
    }
  }
  return result;
}

}  // namespace

std::vector<SuitePair> suite_pairs(const CompareOptions& options) {
  if (!fs::is_directory(options.suite)) throw InputError("", "--suite", "\"" + options.suite + "\"", "a folder");
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(options.suite))
    if (entry.is_directory()) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  std::vector<SuitePair> pairs;
  for (const fs::path& folder : folders)
    if (auto pair = pair_in(folder, options)) {
      if (!has_bounds(pair->options) && !(options.beyond_noise && !pair->options.noise.empty()))
        throw InputError(folder.string(), "", "a pair that nothing judges",
                         "bounds by --bound or bounds.json, or --beyond-noise and test_seed.EXT");
      pairs.push_back(std::move(*pair));
    }
  if (pairs.empty())
    throw InputError(options.suite, "", "no pairs",
                     "folders with test.EXT and reference.EXT (docs/commands/compare.md)");
  return pairs;
}

std::vector<GateResult> judge_suite(const std::vector<SuitePair>& pairs, bool beyond_noise) {
  std::vector<GateResult> results;
  TestFamily family(noise_family_level);
  for (const SuitePair& pair : pairs) {
    const Comparison comparison = compare_files(pair.options);
    for (const ImageMetric& metric : comparison.pictures.metrics)
      if (const auto bound = comparison.bounds.find(metric.key); bound != comparison.bounds.end())
        results.push_back(bound_result(pair, comparison, metric, bound->second));
    if (beyond_noise && !pair.options.noise.empty()) results.push_back(noise_result(pair, comparison, family));
  }
  for (GateResult& result : results)
    if (result.statistic == "largest_z") {
      result.bound = family.one_sided_threshold();
      result.passed = result.value && *result.value <= *result.bound;
    }
  return results;
}

}  // namespace sturm
