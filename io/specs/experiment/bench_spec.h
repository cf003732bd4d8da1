#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/specs/render_spec.h"
#include "lensmodel/words.h"

namespace sturm {

/// One picture to be made again and again: a view with the changes of a method, and one place of the method's sweep.
struct BenchSetting {
  std::string method;  ///< id
  std::string label;   ///< what its place in the sweep changes besides the samples, e.g. "passes 64"; may be ""
  RenderSpec render;   ///< its seed is replaced by that of each round
};

/// A view, what its pictures are measured against, and all settings that it is rendered with.
struct BenchView {
  std::string id, title;
  std::optional<double>
      max_neighbourhood_radiance;      ///< brighter surroundings do not count in the trimmed error; none: all count
  double exposure = 1.0;               ///< before SSIM
  RenderSpec reference;                ///< its samples are those of both halves together
  std::vector<BenchSetting> settings;  ///< by method in the order of the file, then by sweep
};

struct BenchMethod {
  std::string id, title;
  bool denoised = false;  ///< its filtered picture is measured: biased, and compared with nothing but the reference
};

/// What an error is called in files: "rmse", "relative_mse", "relative_mse_trimmed", "one_minus_ssim".
using ErrorName = std::string;

/// One level that methods should reach, for the table of times.
struct ErrorLevel {
  ErrorName error;
  double level = 0.0;
};

enum class BenchStatistic {
  Slope,       ///< of log error against log samples
  Error,       ///< at the method's last setting
  ErrorRatio,  ///< of method over baseline, at the largest number of samples that both were set to
  TimeRatio,   ///< time in which the method reaches the baseline's error at its last setting, over the baseline's time
               ///< for it
  CostRatio    ///< of squared error × seconds, each at its last setting
};

inline constexpr Words<BenchStatistic, 5> bench_statistic_words{{{BenchStatistic::Slope, "slope"},
                                                                 {BenchStatistic::Error, "error"},
                                                                 {BenchStatistic::ErrorRatio, "error_ratio"},
                                                                 {BenchStatistic::TimeRatio, "time_ratio"},
                                                                 {BenchStatistic::CostRatio, "cost_ratio"}}};

/// The word for a statistic as it stands in a benchmark's "require".
inline std::string name_of(BenchStatistic statistic) {
  return std::string(bench_statistic_words.word_of(statistic));
}

/// A bound on a statistic; in each of its views it has to hold.
struct BenchRequirement {
  std::string id, title, reason;
  BenchStatistic statistic = BenchStatistic::Slope;
  ErrorName error;
  std::string method, baseline;    ///< ids; baseline "" where the statistic needs none
  std::vector<std::string> views;  ///< ids
  std::optional<double> at_least, at_most;
};

/// A validated document of format sturm.bench/1.
struct BenchSpec {
  std::string title;
  std::uint64_t seed = 1;
  int rounds = 4;
  std::vector<BenchView> views;
  std::vector<BenchMethod> methods;
  std::vector<ErrorLevel> levels;
  std::vector<BenchRequirement> requirements;
  std::vector<std::string> input_files;  ///< absolute paths, each once
  std::shared_ptr<const Json> resolved;  ///< the document with every default spelt out
};

/// Validates and reads a benchmark; `file` names it in errors and is where relative paths start (paths inside a view's
/// file: at that file, also where a patch brings them). Throws InputError.
BenchSpec read_bench(const Json& document, const std::string& file);

/// The same for a benchmark that stands inside of another document, at `root`.
BenchSpec read_bench(const Json& document, const Source& root);

}  // namespace sturm
