#include "compare/studies/bench/bench_findings.h"

#include "lensmodel/words.h"

namespace sturm {

namespace {

constexpr Words<FloorStatus, 3> floor_words{
    {{FloorStatus::Clear, "ok"}, {FloorStatus::Near, "near_noise_floor"}, {FloorStatus::Below, "below_noise_floor"}}};
constexpr Words<Reach, 3> reach_words{
    {{Reach::Interpolated, "interpolated"}, {Reach::AtOnce, "at_once"}, {Reach::Never, "never"}}};

template <class Value>
Value at_name(const ByError<Value>& values, std::string_view name) {
  const auto found = values.find(std::string(name));
  return found == values.end() ? Value{} : found->second;
}

}  // namespace

template <>
struct WordOf<FloorStatus> {
  static std::string_view word(FloorStatus status) { return floor_words.word_of(status); }
  static std::optional<FloorStatus> value(std::string_view word) { return floor_words.value_of(word); }
};

template <>
struct WordOf<Reach> {
  static std::string_view word(Reach reach) { return reach_words.word_of(reach); }
  static std::optional<Reach> value(std::string_view word) { return reach_words.value_of(word); }
};

template <>
inline constexpr auto record_members<PictureErrors> =
    std::tuple{member("mse", &PictureErrors::mse), member("relative_mse", &PictureErrors::relative_mse),
               member("relative_mse_trimmed", &PictureErrors::relative_mse_trimmed),
               member("one_minus_ssim", &PictureErrors::one_minus_ssim)};

template <>
inline constexpr auto record_members<BenchSample> =
    std::tuple{member("seconds", &BenchSample::seconds), member("samples", &BenchSample::samples),
               member("errors", &BenchSample::errors)};

template <>
inline constexpr auto record_members<BenchMachine> =
    std::tuple{member("cpu", &BenchMachine::cpu),
               member("cores", &BenchMachine::cores),
               member("logical_processors", &BenchMachine::logical_processors),
               member("threads", &BenchMachine::threads),
               member("memory_bytes", &BenchMachine::memory_bytes),
               member("load_at_start", &BenchMachine::load_at_start)};

template <>
inline constexpr auto record_members<BenchReferenceOrigin> =
    std::tuple{member("key", &BenchReferenceOrigin::key),
               member("samples_per_pixel", &BenchReferenceOrigin::samples_per_pixel),
               member("seconds", &BenchReferenceOrigin::seconds),
               member("started_utc", &BenchReferenceOrigin::started_utc),
               member("version", &BenchReferenceOrigin::version),
               member("commit", &BenchReferenceOrigin::commit)};

template <>
inline constexpr auto record_members<BenchReferenceFacts> =
    std::tuple{member("key", &BenchReferenceFacts::key),
               member("samples_per_pixel", &BenchReferenceFacts::samples_per_pixel),
               member("seconds", &BenchReferenceFacts::seconds),
               member("started_utc", &BenchReferenceFacts::started_utc),
               member("version", &BenchReferenceFacts::version),
               member("commit", &BenchReferenceFacts::commit),
               member("file", &BenchReferenceFacts::file),
               member("picture", &BenchReferenceFacts::picture),
               member("noise_floor", &BenchReferenceFacts::noise_floor),
               member("pixels_left_out", &BenchReferenceFacts::pixels_left_out)};

template <>
inline constexpr auto record_members<BenchSeconds> =
    std::tuple{member("median", &BenchSeconds::median), member("shortest", &BenchSeconds::shortest),
               member("longest", &BenchSeconds::longest)};

template <>
inline constexpr auto record_members<BenchError> =
    std::tuple{member("value", &BenchError::value), member("standard_error", &BenchError::standard_error),
               member("raw", &BenchError::raw), member("status", &BenchError::status),
               member("error_seconds", &BenchError::error_seconds)};

template <>
inline constexpr auto record_members<BenchPoint> =
    std::tuple{member("samples_per_pixel", &BenchPoint::samples_per_pixel),
               member("setting", &BenchPoint::setting),
               member("samples", &BenchPoint::samples),
               member("seconds", &BenchPoint::seconds),
               member("samples_per_second", &BenchPoint::samples_per_second),
               member("errors", &BenchPoint::errors)};

template <>
inline constexpr auto record_members<BenchSlope> =
    std::tuple{member("slope", &BenchSlope::slope), member("standard_error", &BenchSlope::standard_error)};

template <>
inline constexpr auto record_members<BenchTime> =
    std::tuple{member("error", &BenchTime::error), member("level", &BenchTime::level),
               member("seconds", &BenchTime::seconds), member("status", &BenchTime::status)};

template <>
inline constexpr auto record_members<BenchMethodResult> =
    std::tuple{member("id", &BenchMethodResult::id),         member("title", &BenchMethodResult::title),
               member("biased", &BenchMethodResult::biased), member("points", &BenchMethodResult::points),
               member("slopes", &BenchMethodResult::slopes), member("times", &BenchMethodResult::times)};

template <>
inline constexpr auto record_members<BenchFrontPoint> = std::tuple{
    member("method", &BenchFrontPoint::method), member("samples_per_pixel", &BenchFrontPoint::samples_per_pixel),
    member("setting", &BenchFrontPoint::setting), member("seconds", &BenchFrontPoint::seconds),
    member("value", &BenchFrontPoint::value)};

template <>
inline constexpr auto record_members<BenchCrossover> =
    std::tuple{member("error", &BenchCrossover::error), member("methods", &BenchCrossover::methods),
               member("seconds", &BenchCrossover::seconds), member("value", &BenchCrossover::value),
               member("better_after", &BenchCrossover::better_after)};

template <>
inline constexpr auto record_members<StatisticValue> =
    std::tuple{member("value", &StatisticValue::value), member("standard_error", &StatisticValue::standard_error),
               member("note", &StatisticValue::note)};

template <>
inline constexpr auto record_members<BenchBest> = std::tuple{member("value", &BenchBest::value),
                                                             member("seconds", &BenchBest::seconds),
                                                             member("samples_per_pixel", &BenchBest::samples_per_pixel),
                                                             member("setting", &BenchBest::setting),
                                                             member("baseline_seconds", &BenchBest::baseline_seconds),
                                                             member("baseline_status", &BenchBest::baseline_status),
                                                             member("times_faster", &BenchBest::times_faster)};

template <>
inline constexpr auto record_members<BenchRatio> = std::tuple{member("error", &BenchRatio::error),
                                                              member("method", &BenchRatio::method),
                                                              member("baseline", &BenchRatio::baseline),
                                                              member("error_ratio", &BenchRatio::error_ratio),
                                                              member("time_ratio", &BenchRatio::time_ratio),
                                                              member("cost_ratio", &BenchRatio::cost_ratio),
                                                              member("at_its_best", &BenchRatio::at_its_best)};

template <>
inline constexpr auto record_members<BenchViewResult> = std::tuple{member("id", &BenchViewResult::id),
                                                                   member("title", &BenchViewResult::title),
                                                                   member("resolution", &BenchViewResult::resolution),
                                                                   member("reference", &BenchViewResult::reference),
                                                                   member("methods", &BenchViewResult::methods),
                                                                   member("pareto", &BenchViewResult::pareto),
                                                                   member("crossovers", &BenchViewResult::crossovers),
                                                                   member("ratios", &BenchViewResult::ratios)};

template <>
inline constexpr auto record_members<BenchRequirementResult> =
    std::tuple{member("id", &BenchRequirementResult::id),
               member("title", &BenchRequirementResult::title),
               member("reason", &BenchRequirementResult::reason),
               member("statistic", &BenchRequirementResult::statistic),
               member("error", &BenchRequirementResult::error),
               member("method", &BenchRequirementResult::method),
               member("baseline", &BenchRequirementResult::baseline),
               member("view", &BenchRequirementResult::view),
               member("at_least", &BenchRequirementResult::at_least),
               member("at_most", &BenchRequirementResult::at_most),
               member("value", &BenchRequirementResult::value),
               member("standard_error", &BenchRequirementResult::standard_error),
               member("note", &BenchRequirementResult::note),
               member("passed", &BenchRequirementResult::passed)};

template <>
inline constexpr auto record_members<BenchVerdict> =
    std::tuple{member("passed", &BenchVerdict::passed), member("sentence", &BenchVerdict::sentence)};

template <>
inline constexpr auto record_members<BenchFindings> =
    std::tuple{member("title", &BenchFindings::title), member("machine", &BenchFindings::machine),
               member("views", &BenchFindings::views), member("requirements", &BenchFindings::requirements),
               member("verdict", &BenchFindings::verdict)};

BenchError BenchPoint::error(std::string_view name) const {
  return at_name(errors, name);
}

BenchSlope BenchMethodResult::slope(std::string_view error) const {
  return at_name(slopes, error).value_or(BenchSlope{});
}

std::string word_of(const std::optional<Reach>& reach) {
  return reach ? std::string(reach_words.word_of(*reach)) : std::string();
}

Json to_json(const BenchFindings& findings) {
  return json_from(findings);
}

std::optional<BenchFindings> bench_findings(const Json& report) {
  return record_from<std::optional<BenchFindings>>(value_at(report, "bench"));
}

BenchFindings bench_report_findings(const Json& bench_report) {
  return record_from<BenchFindings>(bench_report);
}

Json to_json(const BenchViewResult& view) {
  return json_from(view);
}

Json to_json(const std::vector<BenchRequirementResult>& requirements) {
  return json_from(requirements);
}

Json to_json(const BenchReferenceOrigin& origin) {
  return json_from(origin);
}

BenchReferenceOrigin reference_origin_from(const Json& json) {
  return record_from<BenchReferenceOrigin>(json);
}

Json to_json(const std::vector<BenchSample>& round) {
  return json_from(round);
}

std::vector<BenchSample> bench_samples_from(const Json& json) {
  return record_from<std::vector<BenchSample>>(json);
}

}  // namespace sturm
