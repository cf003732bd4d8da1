#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/metrics/ssim.h"
#include "compare/studies/bench/evaluation.h"
#include "compare/studies/bench/reference_image.h"
#include "compare/studies/bench/requirements.h"
#include "compare/studies/bench/two_bench_methods.h"
#include "io/images/tone_map.h"

/// Ratios and errors where methods, settings and rounds are not alike, so that taking the wrong one shows.
namespace sturm {
namespace {

constexpr double ratio_rounding = 1e-12;  // a few operations in double

/// Settings of 4, 16, … samples with these seconds, errors and standard errors.
MethodCurve curve(std::initializer_list<CostPoint> points) {
  MethodCurve result;
  for (const CostPoint& point : points) {
    result.points.push_back(point);
    result.samples_per_pixel.push_back(static_cast<std::uint64_t>(point.samples));
    result.labels.emplace_back();
  }
  return result;
}

TEST(BenchRatios, ErrorsAreComparedAtTheLargestNumberOfSamplesOfBoth) {
  // Half the error at 4 samples, a fifth at 16; the baseline's 64 have no partner.
  const MethodCurve method = curve({{4, 1.0, 0.5, 0.05}, {16, 4.0, 0.06, 0.006}}),
                    baseline = curve({{4, 1.0, 1.0, 0.1}, {16, 4.0, 0.3, 0.0}, {64, 16.0, 0.1, 0.1}});
  const StatisticValue ratio = error_ratio(method, baseline);
  EXPECT_NEAR(ratio.value.value(), 0.2, ratio_rounding);
  EXPECT_NEAR(ratio.standard_error.value(), 0.02, ratio_rounding);  // 10 % of it
  EXPECT_EQ(ratio.note, "at 16 samples per pixel");
}

TEST(BenchRatios, TimesAreAsUncertainAsTheLeastCertainPoint) {
  // Slope −1 in time; the baseline's 0.25 after 8 s is reached after 4 s. Relative errors 3 % here (of three points the
  // largest) and 4 %.
  const MethodCurve method = curve({{4, 1.0, 1.0, 0.01}, {16, 2.0, 0.5, 0.015}, {64, 8.0, 0.125, 0.0}}),
                    baseline = curve({{4, 8.0, 0.25, 0.01}});
  const StatisticValue ratio = time_ratio(method, baseline);
  EXPECT_NEAR(ratio.value.value(), 0.5, ratio_rounding);
  EXPECT_NEAR(ratio.standard_error.value(), 0.5 * 0.05, ratio_rounding);
}

TEST(BenchRatios, TheCostOfARootDoublesItsRelativeError) {
  const MethodCurve method = curve({{4, 1.0, 9.0, 0.0}, {16, 2.0, 0.5, 0.015}}),
                    baseline = curve({{4, 8.0, 0.25, 0.01}});
  // RMSE: 0.25·2/(0.0625·8) = 1 ± 2·5 %; a mean of squares: 0.5·2/(0.25·8) = 0.5 ± 5 %.
  const StatisticValue root = cost_ratio(method, baseline, error_kind("rmse")),
                       square = cost_ratio(method, baseline, error_kind("relative_mse"));
  EXPECT_NEAR(root.value.value(), 1.0, ratio_rounding);
  EXPECT_NEAR(root.standard_error.value(), 0.1, ratio_rounding);
  EXPECT_NEAR(square.value.value(), 0.5, ratio_rounding);
  EXPECT_NEAR(square.standard_error.value(), 0.025, ratio_rounding);
}

TEST(BenchRatios, TheBestSettingNeedNotBeTheLast) {
  const MethodCurve method = curve({{4, 1.0, 0.5, {}}, {16, 2.0, 0.1, {}}, {64, 8.0, 0.2, {}}}),
                    baseline = curve({{4, 1.0, 1.0, {}}, {64, 100.0, 0.01, {}}});
  const auto best = at_its_best(method, baseline);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->index, 1u);
  EXPECT_NEAR(best->times_faster.value(), 5.0, 10 * ratio_rounding);  // the baseline has 0.1 after 10 s
}

TEST(BenchRatios, OfSettingsThatTakeEquallyLongTheBestCounts) {
  const std::vector<CostPoint> points = {{4, 1.0, 1.0, {}}, {16, 4.0, 0.25, {}}, {16, 4.0, 0.5, {}}};
  EXPECT_NEAR(time_to_reach(points, 0.5).seconds.value(), 2.0, ratio_rounding);  // slope −1 to (4 s, 0.25)
}

TEST(BenchRatios, SamplesAreTheMeanOfTheRounds) {
  const MeasuredSetting setting{
      "m", 4, {test::sample(1.0, 8.0, 0.03), test::sample(1.0, 10.0, 0.03), test::sample(1.0, 15.0, 0.03)}, ""};
  EXPECT_NEAR(mean_samples(setting), 11.0, ratio_rounding);
}

TEST(BenchRatios, ReportsSayWhoIsAheadAfterACrossing) {
  // 1/t against 1/(2√t) in squared error: equal at 4 s; "steep" is ahead afterwards.
  MeasuredView view{"v", {}, {}};
  for (const double t : {1.0, 16.0}) {
    view.settings.push_back(
        {"flat", static_cast<std::uint64_t>(t), std::vector(2, test::sample(t, t, 0.5 / std::sqrt(t))), ""});
  }
  for (const double t : {1.0, 16.0})
    view.settings.push_back({"steep", static_cast<std::uint64_t>(t), std::vector(2, test::sample(t, t, 1.0 / t)), ""});
  const Json crossings = to_json(evaluated(view, {{"flat", "F"}, {"steep", "S"}}, {}))["crossovers"];
  ASSERT_EQ(crossings.size(), 4u);  // one per error
  EXPECT_EQ(crossings[1]["error"], "relative_mse");
  EXPECT_NEAR(crossings[1]["seconds"].get<double>(), 4.0, 10 * ratio_rounding);
  EXPECT_NEAR(crossings[1]["value"].get<double>(), 0.25, ratio_rounding);
  EXPECT_EQ(crossings[1]["better_after"], "steep");
}

TEST(BenchRatios, SimilarityIsThatOfDisplayedPictures) {
  // Gradients with a ripple, at an exposure that clips a part of them.
  constexpr int side = 24;
  constexpr double exposure = 3.0;
  Image first(side, side, 3), second = first, test = first;
  for (int i = 0; i < side * side * 3; ++i) {
    first.pixels[i] = 0.001f * static_cast<float>(i % 301);
    second.pixels[i] = first.pixels[i] + 0.02f * static_cast<float>(i % 2);
    test.pixels[i] = first.pixels[i] + 0.05f * static_cast<float>(i % 5);
  }
  const ReferenceImage reference(first, second, std::nullopt, exposure);
  const auto dissimilarity = [&](const Image& a, const Image& b) {
    return 1.0 - ssim(to_display(a, exposure), to_display(b, exposure)).mean;
  };
  EXPECT_NEAR(reference.errors_of(test).one_minus_ssim, dissimilarity(test, reference.mean()), ratio_rounding);
  EXPECT_NEAR(reference.noise_floor().one_minus_ssim, dissimilarity(first, second), ratio_rounding);
  // The numbers can tell: without the exposure, or against the mean of the halves, they are others.
  EXPECT_GT(std::abs(dissimilarity(first, second) - dissimilarity(first, reference.mean())), 1e-3);
  EXPECT_GT(std::abs(dissimilarity(test, reference.mean()) -
                     (1.0 - ssim(to_display(test, 1.0), to_display(reference.mean(), 1.0)).mean)),
            1e-3);
}

}  // namespace
}  // namespace sturm
