#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/fixture_report.h"
#include "reports/text/ellipses_csv.h"

namespace sturm {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// RFC 4180 reader: CRLF ends a row, a doubled quote inside quotes is one.
Rows parse(const std::string& csv) {
  Rows rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    if (quoted && c == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
      rows.back().back() += csv[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      rows.back().emplace_back();
    } else if (!quoted && c == '\r' && csv[i + 1] == '\n') {
      ++i;
      rows.push_back({""});
    } else {
      rows.back().back() += c;
    }
  }
  rows.pop_back();  // what follows the last CRLF
  return rows;
}

std::string at(const Rows& rows, std::size_t row, const std::string& heading) {
  const auto column = std::find(rows[0].begin(), rows[0].end(), heading);
  return column == rows[0].end() ? "no column " + heading
                                 : rows[row][static_cast<std::size_t>(column - rows[0].begin())];
}

TEST(EllipsesCsv, OneRowPerCaseAndRayModel) {
  const Json report = test::synthetic_report();
  const Rows rows = parse(ellipses_csv(read_ellipses(report).cases));
  ASSERT_EQ(rows.size(), 1 + 64 * 5u);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  EXPECT_EQ(at(rows, 1, "ray_model"), "pinhole");
  EXPECT_EQ(at(rows, 5, "ray_model"), "power_matrix");
  EXPECT_EQ(at(rows, 6, "pupil_mm"), "6");
}

TEST(EllipsesCsv, NumbersReadBackExactlyAndNullsAreEmpty) {
  Json report = test::synthetic_report();
  Json& rays = report["ellipses"]["cases"][0]["rays"][0];
  rays["covariance_rad2"] = {0.1 + 0.2, -1.0 / 3.0, 5e-324};
  rays["orientation_deg"] = nullptr;
  const Rows rows = parse(ellipses_csv(read_ellipses(report).cases));
  EXPECT_EQ(std::stod(at(rows, 1, "covariance_xx_rad2")), 0.1 + 0.2);
  EXPECT_EQ(std::stod(at(rows, 1, "covariance_xy_rad2")), -1.0 / 3.0);
  EXPECT_EQ(at(rows, 1, "covariance_yy_rad2"), "5e-324");
  EXPECT_EQ(at(rows, 1, "orientation_deg"), "");
  EXPECT_EQ(at(rows, 61, "distance_m"), "4");  // second prescription (40 rows each), third distance (10 rows each)
}

TEST(EllipsesCsv, InfiniteDistanceIsItsWord) {
  const Rows rows = parse(ellipses_csv(read_ellipses(test::synthetic_report()).cases));
  EXPECT_EQ(at(rows, 31, "distance_m"), "inf");  // the fourth distance, first pupil
}

TEST(EllipsesCsv, QuotesWhatNeedsQuoting) {
  Json report = test::synthetic_report();
  const std::string hostile = "a,\"b\"\r\nc";
  report["ellipses"]["cases"][0]["id"] = hostile;
  const std::string csv = ellipses_csv(read_ellipses(report).cases);
  EXPECT_THAT(csv, ::testing::HasSubstr("\r\n\"a,\"\"b\"\"\r\nc\",plano,"));
  EXPECT_EQ(at(parse(csv), 1, "case"), hostile);
}

TEST(EllipsesCsv, ReportWithoutEllipsesHasAHeaderOnly) {
  EXPECT_EQ(parse(ellipses_csv({})).size(), 1u);
}

}  // namespace
}  // namespace sturm
