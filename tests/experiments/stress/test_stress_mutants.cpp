// The suite must notice what it is there for: conoids that are wrong on purpose, each of them caught by the checks that
// should.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/stress/generator.h"
#include "experiments/stress/suite.h"
#include "experiments/stress/transformed_lens.h"
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

ConoidTracer remounted(Mounting (*change)(const Mounting&)) {
  return [change](const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m) {
    Spectacles wrong = lens;
    wrong.mounting = change(lens.mounting);
    return trace_conoid(wrong, gaze, rotation_center_m);
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
      {"transposed blocks",
       changed([](SpectacleConoid& c) { c.exit.offset_from_offset.transposeInPlace(); }),
       {Check::footprint},
       0.5},
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
      {"a direction off by 1e-12",
       changed([](SpectacleConoid& c) { c.chief_ray.direction.y() += 1e-12; }),
       {Check::exit_direction},
       0.8},
      {"a NaN",
       changed([](SpectacleConoid& c) { c.exit.slope_from_offset(0, 0) = std::nan(""); }),
       {Check::finite, Check::footprint},
       0.9},
      {"an axis that is mirrored",
       [](const Spectacles& lens, const Eigen::Vector3d& gaze, double center) {
         return trace_conoid(mirrored(lens), gaze, center);
       },
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
      // Of the lenses that a ray comes through, about a sixth is mounted (one angle in five is 0), a twentieth has a
      // prism, a thirtieth a spline.
      {"the sign of the wrap",
       remounted([](const Mounting& m) {
         return Mounting(m.decentration_m(), m.pantoscopic_tilt(), -m.wrap()).with_wedge(m.wedge());
       }),
       {Check::footprint, Check::exit_point, Check::turned},
       0.12},
      {"tilt and wrap exchanged",
       remounted([](const Mounting& m) {
         return Mounting(m.decentration_m(), m.wrap(), m.pantoscopic_tilt()).with_wedge(m.wedge());
       }),
       {Check::footprint, Check::mirrored, Check::turned},
       0.12},
      {"decentration the other way",
       remounted([](const Mounting& m) {
         return Mounting(-m.decentration_m(), m.pantoscopic_tilt(), m.wrap()).with_wedge(m.wedge());
       }),
       {Check::footprint},
       0.12},
      {"a base on the other side",
       remounted([](const Mounting& m) {
         return Mounting(m.decentration_m(), m.pantoscopic_tilt(), m.wrap())
             .with_wedge({-m.wedge().x(), m.wedge().y()});
       }),
       {Check::footprint, Check::turned},
       0.03},
      {"splines 1 nm higher",
       [](const Spectacles& lens, const Eigen::Vector3d& gaze, double center) {
         Spectacles higher = lens;
         for (Surface* surface : {&higher.back, &higher.front})
           if (const auto* spline = std::get_if<BSplineSurface>(surface)) *surface = spline->raised(1e-9);
         return trace_conoid(higher, gaze, center);
       },
       {Check::exit_point, Check::scaled},
       0.02},
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
  const FreeFormLenses lenses;
  const auto document = [&](std::uint64_t seed, std::uint64_t index) {
    return query_json(draw_case(seed, index, lenses), lenses);
  };
  EXPECT_EQ(document(5, 1234), document(5, 1234));
  EXPECT_NE(document(5, 1234), document(5, 1235));
  EXPECT_NE(document(5, 1234), document(6, 1234));
}

TEST(StressGenerator, SharesSumToOne) {
  double sum = 0.0;
  for (const FamilyInfo& f : families) sum += f.share;
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(StressGenerator, DocumentsAreTheCasesToTheLastBit) {
  const FreeFormLenses lenses;
  int mounted = 0, with_prism = 0, progressive = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    const CaseNumbers n = draw_case(3, i, lenses);
    if (n.lens && n.lens->free_form && lenses.table(*n.lens->free_form))
      continue;  // a document with a file; end to end
    if (n.lens) {
      mounted += n.lens->mounting != MountingNumbers();
      with_prism += n.lens->made.has_value();
      progressive += n.lens->free_form.has_value();
    }
    const auto eye = eye_of(n);
    if (!eye) continue;
    const EllipseQuery query = read_ellipse_query(query_json(n, lenses), "case");
    EXPECT_EQ(query.eye.correction.matrix(), eye->correction.matrix()) << i;
    EXPECT_EQ(query.eye.rotation_center_m, eye->rotation_center_m) << i;
    EXPECT_EQ(query.targets[0].distance_m, n.distance_m) << i;
    ASSERT_EQ(query.spectacles.has_value(), n.lens.has_value()) << i;
    if (!n.lens) continue;
    const SpectacleConoid a =
        trace_conoid(*query.spectacles, gaze_direction(query.targets[0].azimuth, query.targets[0].elevation),
                     eye->rotation_center_m);
    const SpectacleConoid b = trace_conoid(spectacles_of(*n.lens, lenses), gaze_of(n), eye->rotation_center_m);
    ASSERT_EQ(a.status, b.status) << i;
    if (a.status != LensStatus::ok) continue;
    EXPECT_EQ(a.exit.slope_from_offset, b.exit.slope_from_offset) << i;
  }
  EXPECT_GT(mounted, 60);
  EXPECT_GT(with_prism, 10);
  EXPECT_GT(progressive, 3);
}

}  // namespace
}  // namespace sturm::stress
