#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/gates/extreme_statistic.h"
#include "compare/studies/bench/measured_view.h"
#include "io/json/record.h"

namespace sturm {

/// The machine, which the times depend on besides the program.
struct BenchMachine {
  std::string cpu{};
  Count cores{}, logical_processors{}, threads{}, memory_bytes{};
  std::optional<std::vector<double>> load_at_start{};  ///< over 1, 5 and 15 minutes

  bool operator==(const BenchMachine&) const = default;
};

/// One number for each kind of error, by its name (error_kinds).
template <class Value>
using ByError = std::map<std::string, Value>;

/// What made a reference; it stands beside the reference's pictures.
struct BenchReferenceOrigin {
  std::string key{};
  Count samples_per_pixel{};
  Number seconds{};
  std::string started_utc{}, version{}, commit{};

  bool operator==(const BenchReferenceOrigin&) const = default;
};

/// The picture that the others are measured against.
struct BenchReferenceFacts : BenchReferenceOrigin {
  std::string file{}, picture{};  ///< EXR and PNG in the run folder
  ByError<Number> noise_floor{};
  Count pixels_left_out{};

  bool operator==(const BenchReferenceFacts&) const = default;
};

struct BenchSeconds {
  Number median{}, shortest{}, longest{};

  bool operator==(const BenchSeconds&) const = default;
};

struct BenchError {
  Number value{}, standard_error{};
  Number raw{};  ///< as measured, the reference's noise included
  std::optional<FloorStatus> status{};
  Number error_seconds{};  ///< squared error × seconds

  bool operator==(const BenchError&) const = default;
};

/// One setting of a method.
struct BenchPoint {
  Count samples_per_pixel{};
  std::string setting{};  ///< what else this place in the sweep changes
  Number samples{};       ///< camera rays of the whole picture
  BenchSeconds seconds{};
  Number samples_per_second{};
  ByError<BenchError> errors{};

  bool operator==(const BenchPoint&) const = default;

  /// Without numbers where there is none of that name.
  BenchError error(std::string_view name) const;
};

/// Of log error against log samples.
struct BenchSlope {
  Number slope{}, standard_error{};

  bool operator==(const BenchSlope&) const = default;
};

/// The time to reach one level of error.
struct BenchTime {
  std::string error{};
  Number level{}, seconds{};
  std::optional<Reach> status{};

  bool operator==(const BenchTime&) const = default;
};

struct BenchMethodResult {
  std::string id{}, title{};
  bool biased = false;  ///< a filtered picture was measured, which takes part in no ratio, front or crossing
  std::vector<BenchPoint> points{};
  ByError<std::optional<BenchSlope>> slopes{};
  std::vector<BenchTime> times{};

  bool operator==(const BenchMethodResult&) const = default;

  /// Without numbers where there is none of that name.
  BenchSlope slope(std::string_view error) const;
};

/// A setting that no other beats in one error.
struct BenchFrontPoint {
  std::string method{};
  Count samples_per_pixel{};
  std::string setting{};
  Number seconds{}, value{};

  bool operator==(const BenchFrontPoint&) const = default;
};

/// Where two methods need the same time for the same error.
struct BenchCrossover {
  std::string error{};
  std::array<std::string, 2> methods{};
  Number seconds{}, value{};
  std::string better_after{};  ///< the method that is better with more time

  bool operator==(const BenchCrossover&) const = default;
};

/// A statistic of one view. No value where an error drowned in the reference's noise or was never reached; the note
/// says so.
struct StatisticValue {
  Number value{}, standard_error{};
  std::string note{};

  bool operator==(const StatisticValue&) const = default;
};

/// A method at its least error, and the baseline's time for the same.
struct BenchBest {
  Number value{}, seconds{};
  Count samples_per_pixel{};
  std::string setting{};
  Number baseline_seconds{};
  std::optional<Reach> baseline_status{};
  Number times_faster{};

  bool operator==(const BenchBest&) const = default;
};

/// A method of a view over the view's first one.
struct BenchRatio {
  std::string error{}, method{}, baseline{};
  StatisticValue error_ratio{}, time_ratio{}, cost_ratio{};
  std::optional<BenchBest> at_its_best{};

  bool operator==(const BenchRatio&) const = default;
};

struct BenchViewResult {
  std::string id{}, title{};
  std::array<Count, 2> resolution{};
  BenchReferenceFacts reference{};
  std::vector<BenchMethodResult> methods{};
  ByError<std::vector<BenchFrontPoint>> pareto{};
  std::vector<BenchCrossover> crossovers{};
  std::vector<BenchRatio> ratios{};

  bool operator==(const BenchViewResult&) const = default;

  /// Of one picture; 1 where the resolution is not known.
  double pixels() const { return Number(resolution[0]).value_or(1.0) * Number(resolution[1]).value_or(1.0); }
};

/// A requirement in one view.
struct BenchRequirementResult {
  std::string id{}, title{}, reason{}, statistic{}, error{}, method{};
  std::optional<std::string> baseline{};
  std::string view{};
  Number at_least{}, at_most{}, value{}, standard_error{};
  std::string note{};
  bool passed = false;

  bool operator==(const BenchRequirementResult&) const = default;
};

struct BenchVerdict {
  bool passed = false;
  std::string sentence{};

  bool operator==(const BenchVerdict&) const = default;
};

/// Section "bench" of a report, and the findings of a benchmark's own report (sturm.bench_report/1).
struct BenchFindings {
  std::string title{};
  BenchMachine machine{};
  std::vector<BenchViewResult> views{};
  std::vector<BenchRequirementResult> requirements{};
  BenchVerdict verdict{};

  bool operator==(const BenchFindings&) const = default;
};

Json to_json(const BenchFindings& findings);

/// Of an experiment's report; none without the section.
std::optional<BenchFindings> bench_findings(const Json& report);

/// Of a benchmark's own report.
BenchFindings bench_report_findings(const Json& bench_report);

/// The word of a report for how a level was reached; "" if it is not known.
std::string word_of(const std::optional<Reach>& reach);

/// Parts of the findings.
Json to_json(const BenchViewResult& view);
Json to_json(const std::vector<BenchRequirementResult>& requirements);

/// Both ways: what a reference's file says, and the renderings of one round in the order of a view's settings.
Json to_json(const BenchReferenceOrigin& origin);
BenchReferenceOrigin reference_origin_from(const Json& json);
Json to_json(const std::vector<BenchSample>& round);
std::vector<BenchSample> bench_samples_from(const Json& json);

}  // namespace sturm
