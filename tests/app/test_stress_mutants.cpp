// The suite must notice what it is there for: conoids that are wrong on purpose, each of them caught by the checks that should.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/stress/generator.h"
#include "app/stress/suite.h"
#include "app/stress/transformed_lens.h"
#include "lensmodel/gaze.h"

namespace sturm::stress {
namespace {

using Change = void (*)(SpectacleConoid&);

ConoidTracer changed(Change change) {
  return [change](const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m) {
    SpectacleConoid c = trace_conoid(lens, gaze, rotation_center_m);
    if (c.status == LensStatus::ok) change(c);
    return c;
  };
}

/// Parts of the cases that came through in which each check is over its bound.
double share_over(const SuiteSummary& s, Check check) {
  const CheckSummary& c = s.checks[static_cast<std::size_t>(check)];
  return c.run > 0 ? static_cast<double>(c.over) / static_cast<double>(c.run) : 0.0;
}

SuiteSummary suite(const ConoidTracer& tracer) {
  return run_suite(
      {2000, 7}, [](double) {}, tracer);
}

TEST(StressMutants, TheRightConoidPasses) {
  const SuiteSummary s = suite(trace_conoid);
  EXPECT_TRUE(s.passed()) << s.first_failed.size();
}

TEST(StressMutants, EachIsCaught) {
  struct Mutant {
    const char* what;
    ConoidTracer tracer;
    std::vector<Check> caught_by;
    double share;  ///< of the cases that come through, at least
  };
  const std::vector<Mutant> mutants{
      {"the sign of the power",
       changed([](SpectacleConoid& c) { c.exit.slope_from_offset *= -1.0; }),
       {Check::footprint, Check::symplectic},
       0.9},
      {"the sign of the twist",
       changed([](SpectacleConoid& c) {
         c.exit.slope_from_offset(0, 1) *= -1.0;
         c.exit.slope_from_offset(1, 0) *= -1.0;
       }),
       {Check::footprint, Check::turned},
       0.5},
      {"transposed blocks", changed([](SpectacleConoid& c) { c.exit.offset_from_offset.transposeInPlace(); }), {Check::footprint}, 0.5},
      {"a relative error of 1e-11",
       changed([](SpectacleConoid& c) { c.exit.slope_from_slope *= 1.0 + 1e-11; }),
       {Check::footprint, Check::symplectic},
       0.8},
      {"a dropped cosine",
       changed([](SpectacleConoid& c) { c.exit.offset_from_slope.row(0) *= std::abs(c.chief_ray.direction.z()); }),
       {Check::footprint, Check::symplectic},
       0.8},
      {"an exit point 1 nm aside",
       changed([](SpectacleConoid& c) { c.chief_ray.origin.x() += 1e-9; }),
       {Check::exit_point, Check::mirrored},
       0.9},
      {"a direction off by 1e-12", changed([](SpectacleConoid& c) { c.chief_ray.direction.y() += 1e-12; }), {Check::exit_direction}, 0.8},
      {"a NaN", changed([](SpectacleConoid& c) { c.exit.slope_from_offset(0, 0) = std::nan(""); }), {Check::finite, Check::footprint}, 0.9},
      {"an axis that is mirrored",
       [](const Spectacles& lens, const Eigen::Vector3d& gaze, double center) { return trace_conoid(mirrored(lens), gaze, center); },
       {Check::footprint, Check::turned},
       0.4},
      {"an absolute length of 1e-9 m",
       [](const Spectacles& lens, const Eigen::Vector3d& gaze, double center) {
         Spectacles thicker = lens;
         thicker.center_thickness_m += 1e-9;
         return trace_conoid(thicker, gaze, center);
       },
       {Check::scaled, Check::exit_point},
       0.7},
      {"a gaze that is mirrored",
       [](const Spectacles& lens, const Eigen::Vector3d& gaze, double center) {
         return trace_conoid(lens, Eigen::Vector3d(-gaze.x(), gaze.y(), gaze.z()), center);
       },
       {Check::exit_point, Check::turned},
       0.5},
  };
  for (const Mutant& m : mutants) {
    const SuiteSummary s = suite(m.tracer);
    EXPECT_FALSE(s.passed()) << m.what;
    for (const Check check : m.caught_by)
      EXPECT_GE(share_over(s, check), m.share) << m.what << ": " << checks[static_cast<std::size_t>(check)].name;
  }
}

TEST(StressMutants, LostRaysAreCaught) {
  const SuiteSummary s = suite([](const Spectacles& lens, const Eigen::Vector3d& gaze, double center) {
    SpectacleConoid c = trace_conoid(lens, gaze, center);
    c.status = LensStatus::missed_lens;
    return c;
  });
  EXPECT_GE(share_over(s, Check::status), 0.6);
}

TEST(StressGenerator, CasesAreAddressed) {
  const Json once = query_json(draw_case(5, 1234)), again = query_json(draw_case(5, 1234));
  EXPECT_EQ(once, again);
  EXPECT_NE(once, query_json(draw_case(5, 1235)));
  EXPECT_NE(once, query_json(draw_case(6, 1234)));
}

TEST(StressGenerator, SharesSumToOne) {
  double sum = 0.0;
  for (const FamilyInfo& f : families) sum += f.share;
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(StressGenerator, DocumentsAreTheCasesToTheLastBit) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    const CaseNumbers n = draw_case(3, i);
    const auto eye = eye_of(n);
    if (!eye) continue;
    const EllipseQuery query = read_ellipse_query(query_json(n), "case");
    EXPECT_EQ(query.eye.correction.matrix(), eye->correction.matrix()) << i;
    EXPECT_EQ(query.eye.rotation_center_m, eye->rotation_center_m) << i;
    EXPECT_EQ(query.targets[0].distance_m, n.distance_m) << i;
    ASSERT_EQ(query.spectacles.has_value(), n.lens.has_value()) << i;
    if (!n.lens) continue;
    const SpectacleConoid a =
        trace_conoid(*query.spectacles, gaze_direction(query.targets[0].azimuth, query.targets[0].elevation), eye->rotation_center_m);
    const SpectacleConoid b = trace_conoid(spectacles_of(*n.lens), gaze_of(n), eye->rotation_center_m);
    ASSERT_EQ(a.status, b.status) << i;
    if (a.status != LensStatus::ok) continue;
    EXPECT_EQ(a.exit.slope_from_offset, b.exit.slope_from_offset) << i;
  }
}

}  // namespace
}  // namespace sturm::stress
