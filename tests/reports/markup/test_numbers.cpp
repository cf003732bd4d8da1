#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/json/record.h"
#include "reports/markup/numbers.h"

namespace sturm {
namespace {

TEST(ReportNumbers, RoundToSignificantDigits) {
  EXPECT_EQ(number_html(0.70710678).markup(), "0.7071");
  EXPECT_EQ(number_html(-12.3456, 3).markup(), "−12.3");
  EXPECT_EQ(number_html(0.0).markup(), "0");
  EXPECT_EQ(number_html(9.9996, 4).markup(), "10.00");  // rounding carries into the next decade
  EXPECT_EQ(number_html(1.2345e-5, 3).markup(), "1.23 × 10<sup>−5</sup>");
  EXPECT_EQ(number_html(-4.5e8, 2).markup(), "−4.5 × 10<sup>8</sup>");
}

TEST(ReportNumbers, AbsentAndNonFiniteNumbersAreADash) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(number_html(bad).markup(), "–");
    EXPECT_EQ(exact_html(bad).markup(), "–");
    EXPECT_EQ(measured_html(bad, 0.1).markup(), "–");
    EXPECT_EQ(measured_html(1.25, bad).markup(), "1.250");
    EXPECT_EQ(count_html(bad).markup(), "–");
    EXPECT_EQ(duration_html(bad).markup(), "–");
  }
  EXPECT_EQ(number_html(std::nullopt).markup(), "–");
}

TEST(ReportNumbers, UncertaintyDecidesTheDigits) {
  EXPECT_EQ(measured_html(0.987123, 0.00114).markup(), "0.9871 ± 0.0011");
  EXPECT_EQ(measured_html(-3.14159, 0.25).markup(), "−3.14 ± 0.25");
  EXPECT_EQ(measured_html(1234.6, 37.2).markup(), "1235 ± 37");
  EXPECT_EQ(measured_html(4.1234e-6, 1.1e-7).markup(), "(4.12 ± 0.11) × 10<sup>−6</sup>");
  EXPECT_EQ(measured_html(0.98712, std::nullopt).markup(), "0.9871");
  EXPECT_EQ(measured_html(0.0001, 0.25).markup(), "0.00 ± 0.25");
  EXPECT_EQ(measured_html(-0.0001, 0.25).markup(), "0.00 ± 0.25");  // no "minus zero"
}

TEST(ReportNumbers, StackedUncertaintyIsARemark) {
  EXPECT_EQ(stacked_html(0.987123, 0.00114).markup(), "0.9871<small>± 0.0011</small>");
  EXPECT_EQ(stacked_html(4.1234e-6, 1.1e-7).markup(), "(4.12 ± 0.11) × 10<sup>−6</sup>");  // one power for both
  EXPECT_EQ(stacked_html(0.98712, std::nullopt).markup(), "0.9871");
}

TEST(ReportNumbers, ChosenNumbersStayShort) {
  EXPECT_EQ(exact_html(4.0).markup(), "4");
  EXPECT_EQ(exact_html(-2.5).markup(), "−2.5");
  EXPECT_EQ(exact_html(1e-12).markup(), "1 × 10<sup>−12</sup>");
}

TEST(ReportNumbers, CountsDurationsDistances) {
  EXPECT_EQ(count_html(262144).markup(), "262\u2009144");
  EXPECT_EQ(count_html(999).markup(), "999");
  EXPECT_EQ(duration_html(8.25).markup(), "8.2\u00a0s");
  EXPECT_EQ(duration_html(203.4).markup(), "3\u00a0min\u00a023\u00a0s");
  EXPECT_EQ(duration_html(3899.0).markup(), "1\u00a0h\u00a004\u00a0min");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(distance_html(std::optional(infinity)).markup(), "∞");
  EXPECT_EQ(distance_html(std::optional(0.4)).markup(), "0.4");
  EXPECT_EQ(distance_html(std::optional<double>()).markup(), "–");
  EXPECT_EQ(distance_html(std::optional(StoredDistance{infinity})).markup(), "∞");
  EXPECT_EQ(distance_html(std::optional(StoredDistance{0.4})).markup(), "0.4");
  EXPECT_EQ(distance_html(std::optional<StoredDistance>()).markup(), "–");
}

RC_GTEST_PROP(ReportNumbers, WhatIsShownIsWithinHalfADigit, (double mantissa, int exponent)) {
  const double value = std::fmod(mantissa, 10.0) * std::pow(10.0, exponent % 12);
  RC_PRE(value != 0.0 && std::isfinite(value));
  std::string text = number_html(value, 4).markup();
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at; (at = text.find(from)) != std::string::npos;) text.replace(at, from.size(), to);
  };
  replace("−", "-");
  replace(" × 10<sup>", "e");
  replace("</sup>", "");
  RC_ASSERT(std::abs(std::stod(text) - value) <=
            0.5001e-3 * std::abs(value));  // four digits: at most half of 1 in 1000
}

}  // namespace
}  // namespace sturm
