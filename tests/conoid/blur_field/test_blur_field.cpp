// Blur fields against the conoids that they are made of, and against the same field without shortcuts.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "conoid/blur_field/depth_analytic_field.h"
#include "conoid/blur_field/field_exr.h"
#include "conoid/blur_field/voxel_fill.h"
#include "conoid/tracing/previous.h"
#include "conoid/tracing/published.h"
#include "lensmodel/best_accommodation.h"
#include "lensmodel/single_vision.h"
#include "lensmodel/symmetric2.h"
#include "support/fixed_rapidcheck_seed.h"

namespace sturm {
namespace {

constexpr double center = 13.5e-3;
constexpr float single = 6e-8f;  // rounding of single precision

Eye eye_with(const Accommodation& accommodation) {
  return Eye::with({-4.0, -2.0, 30.0, 12e-3}, 4e-3, accommodation);
}

const FieldGrid small{.nx = 7,
                      .ny = 5,
                      .nz = 9,
                      .tan_half_width = 0.6,
                      .tan_half_height = 0.4,
                      .near_vergence_D = 4.0,
                      .far_vergence_D = 0.0};

TEST(FieldGrid, NodesLieOnTheEdges) {
  EXPECT_EQ(small.ndc_x(0), -1.0);
  EXPECT_EQ(small.ndc_x(6), 1.0);
  EXPECT_EQ(small.ndc_y(0), 1.0);  // the upper row comes first
  EXPECT_EQ(small.ndc_y(4), -1.0);
  EXPECT_EQ(small.vergence(0), 4.0);
  EXPECT_EQ(small.vergence(8), 0.0);
  EXPECT_EQ(small.vergence(2), 3.0);
  const Eigen::Vector3d upper_left = small.line_of_sight(-1.0, 1.0);
  EXPECT_NEAR(upper_left.x() / -upper_left.z(), -0.6, 1e-15);
  EXPECT_NEAR(upper_left.y() / -upper_left.z(), 0.4, 1e-15);
}

TEST(BestAccommodation, IsTheLeastLargerSemiAxis) {
  // Against a golden-section search of what it minimises, which knows nothing of complex planes. The minimum of a
  // smooth function is found by its values to the root of the rounding, 1e-8.
  const auto larger = [](const Eigen::Matrix2d& m, const Eigen::Matrix2d& n, double a) {
    return singular_values(m - a * n).large;
  };
  rc::check([&] {
    const auto entry = [](int scale) { return *rc::gen::inRange(-1000, 1001) * 1e-3 * scale; };
    const Eigen::Matrix2d m{{entry(5), entry(2)}, {entry(2), entry(5)}},
        n{{1.0 + 0.3 * entry(1), 0.2 * entry(1)}, {0.2 * entry(1), 1.0 + 0.3 * entry(1)}};
    const double amplitude = *rc::gen::inRange(1, 100) * 0.1, found = best_accommodation(m, n, amplitude);
    RC_ASSERT(found >= 0.0 && found <= amplitude);
    double low = 0.0, high = amplitude;
    while (high - low > 1e-9) {
      const double left = low + 0.382 * (high - low), right = low + 0.618 * (high - low);
      (larger(m, n, left) <= larger(m, n, right) ? high : low) =
          larger(m, n, left) <= larger(m, n, right) ? right : left;
    }
    RC_ASSERT(larger(m, n, found) <= larger(m, n, 0.5 * (low + high)) + 1e-14);
  });
}

TEST(BestAccommodation, StopsExactlyAtTheKinkOfASphericalEye) {
  // X = (2.5 − A) I: a sharp point, the sum of distances has a kink there.
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
  EXPECT_NEAR(best_accommodation(2.5 * one, one, 10.0), 2.5, 1e-14);
  EXPECT_EQ(best_accommodation(-1.0 * one, one, 10.0), 0.0);
  EXPECT_EQ(best_accommodation(12.0 * one, one, 10.0), 10.0);
  EXPECT_EQ(best_accommodation(one, Eigen::Matrix2d::Zero(), 10.0),
            0.0);  // accommodation changes nothing: the least of equals
  // Naked eye: the circle of least confusion, A = M.
  EXPECT_NEAR(best_accommodation(Eigen::Matrix2d{{1.0, 0.4}, {0.4, 3.0}}, one, 10.0), 2.0, 1e-14);
}

struct LensCase {
  const char* name;
  Spectacles lens;
};

std::vector<LensCase> lenses() {
  SingleVisionDesign tilted;
  tilted.mounting = Mounting({2e-3, -1e-3}, 0.15, 0.1);
  return {{"oblique toric", single_vision({-4.0, -2.0, 30.0}, {})},
          {"upright toric", single_vision({3.0, -2.0, 90.0}, {})},
          {"sphere", single_vision({-6.0}, {})},
          {"tilted", single_vision({-4.0, -2.0, 30.0}, tilted)}};
}

TEST(DepthAnalyticField, IsTheConoidAtEveryNodeDistanceAndAccommodation) {
  const Eye eye = eye_with(RelaxedAccommodation{});
  for (const LensCase& c : lenses()) {
    const TracedDirections directions = trace_directions(&c.lens, center, small);
    const DepthAnalyticField field(small, directions, eye.correction);
    for (const int i : {0, 3, 6})
      for (const int j : {0, 2, 4})
        for (const double vergence : {0.0, 0.37, 2.0, 9.0})  // also nearer than the grid's near plane
          for (const double accommodation : {0.0, 1.7}) {
            const Eigen::Matrix2d exact = directions.conoids[small.index(i, j)].angular_footprint(
                eye.slope_matrix(accommodation).matrix(), vergence);
            const auto stored =
                field.angular_footprint(static_cast<float>(small.ndc_x(i)), static_cast<float>(small.ndc_y(j)),
                                        static_cast<float>(vergence), static_cast<float>(accommodation));
            ASSERT_TRUE(stored) << c.name;
            // Four terms of at most 15 rad/m, each rounded a few times, and the node's place in single precision.
            EXPECT_LT((stored->cast<double>() - exact).norm(), 100.0 * single * (1.0 + exact.norm() + vergence))
                << c.name;
          }
  }
}

TEST(DepthAnalyticField, NothingOutsideOfTheFieldOrTheRim) {
  Spectacles lens = single_vision({-4.0}, {});
  lens.diameter_m = 20e-3;
  const TracedDirections directions = trace_directions(&lens, center, small);
  const DepthAnalyticField field(small, directions, PowerMatrix::scalar(-4.0));
  EXPECT_TRUE(field.angular_footprint(0.1f, 0.1f, 1.0f, 0.0f));
  EXPECT_FALSE(field.angular_footprint(1.01f, 0.0f, 1.0f, 0.0f));
  EXPECT_FALSE(field.angular_footprint(0.0f, -1.01f, 1.0f, 0.0f));
  EXPECT_FALSE(field.angular_footprint(0.95f, 0.95f, 1.0f, 0.0f));
  EXPECT_FALSE(field.angular_footprint(NAN, 0.0f, 1.0f, 0.0f));
}

/// The bilinear error is of second order in the grid's spacing.
TEST(DepthAnalyticField, InterpolationConvergesWithTheSquareOfTheSpacing) {
  const Spectacles lens = single_vision({-4.0, -2.0, 30.0}, {});
  const Eye eye = eye_with(RelaxedAccommodation{});
  const auto error = [&](int n) {
    FieldGrid grid = small;
    grid.nx = grid.ny = n;
    const DepthAnalyticField field(grid, trace_directions(&lens, center, grid), eye.correction);
    const double x = 2.0 / (n - 1) * (n / 4 + 0.5) - 1.0, y = x;  // the middle of a cell
    const SpectacleConoid exact = trace_conoid(lens, grid.line_of_sight(x, y), center);
    return (field.angular_footprint(static_cast<float>(x), static_cast<float>(y), 1.0f, 0.0f)->cast<double>() -
            exact.angular_footprint(eye.slope_matrix(0.0).matrix(), 1.0))
        .norm();
  };
  const double order = std::log2(error(9) / error(17));
  EXPECT_NEAR(order, 2.0, 0.4);  // the cell's middle moves between the two grids
}

TEST(VoxelField, HoldsTheConoidInEveryModeOfAccommodation) {
  for (const LensCase& c : lenses()) {
    const TracedDirections directions = trace_directions(&c.lens, center, small);
    for (const Accommodation& mode :
         {Accommodation(RelaxedAccommodation{}), Accommodation(FixedAccommodation{1.5, 0.0}),
          Accommodation(BestAccommodation{3.0})}) {
      const Eye eye = eye_with(mode);
      const VoxelField field = fill_voxels(&c.lens, eye, small, directions);
      for (const int k : {0, 1, 4, 8}) {
        const SpectacleConoid& conoid = directions.conoids[small.index(2, 1)];
        const double vergence = small.vergence(k), a = accommodation_through(conoid, eye, vergence);
        const Eigen::Matrix2d exact = conoid.angular_footprint(eye.slope_matrix(a).matrix(), vergence);
        const auto stored = field.angular_footprint(small.ndc_x(2), small.ndc_y(1), vergence);
        ASSERT_TRUE(stored);
        EXPECT_LT((stored->cast<double>() - exact).norm(),
                  20.0 * single * (1.0 + conoid.angular_p(vergence).norm() + 8.0))
            << c.name;
      }
    }
  }
}

TEST(VoxelField, LinearInDepthBetweenTheSlices) {
  const Spectacles lens = single_vision({-4.0, -2.0, 30.0}, {});
  const Eye eye = eye_with(RelaxedAccommodation{});
  const TracedDirections directions = trace_directions(&lens, center, small);
  const VoxelField field = fill_voxels(&lens, eye, small, directions);
  const DepthAnalyticField analytic(small, directions, eye.correction);
  // X/d is affine in 1/d, so uniform dioptres and linear interpolation lose nothing; both interpolate the direction
  // alike.
  for (const double vergence : {0.1, 1.27, 3.99})
    EXPECT_LT((*field.angular_footprint(0.13, -0.71, vergence) -
               *analytic.angular_footprint(0.13f, -0.71f, static_cast<float>(vergence), 0.0f))
                  .norm(),
              50.0f * single * 10.0f);
  EXPECT_FALSE(field.angular_footprint(0.0, 0.0, 4.01));
  EXPECT_FALSE(field.angular_footprint(0.0, 0.0, -0.01));
}

TEST(VoxelField, PublishedAndPreviousAreTheMethodsThemselves) {
  const Spectacles lens = single_vision({-4.0, -2.0, 30.0}, {});
  const Eye eye = eye_with(FixedAccommodation{1.0, 0.0});
  const TracedDirections directions = trace_directions(&lens, center, small);
  const VoxelField published = fill_voxels(&lens, eye, small, directions, FieldMethod::published),
                   previous = fill_voxels(&lens, eye, small, directions, FieldMethod::previous);
  const Eigen::Vector3d gaze = small.line_of_sight(small.ndc_x(5), small.ndc_y(3));
  const RayTransfer& frame = directions.conoids[small.index(5, 3)].exit;
  for (const int k : {0, 3, 8}) {
    const double vergence = small.vergence(k);
    const auto exact = trace_published(eye, 1.0, &lens, gaze);
    ASSERT_TRUE(exact);
    EXPECT_LT((published.angular_footprint(small.ndc_x(5), small.ndc_y(3), vergence)->cast<double>() -
               angular_map(*exact, frame.e1, frame.e2, vergence))
                  .norm(),
              1e-5);
    EXPECT_LT((previous.angular_footprint(small.ndc_x(5), small.ndc_y(3), vergence)->cast<double>() -
               *previous_angular_footprint(eye, 1.0, &lens, gaze, 1.0 / vergence))
                  .norm(),
              1e-5);
  }
}

TEST(VoxelField, OnlyVisibleVoxelsAreStoredAndTheyAreTheSame) {
  const Spectacles lens = single_vision({-4.0, -2.0, 30.0}, {});
  for (const FieldMethod method : {FieldMethod::ray_transfer, FieldMethod::published, FieldMethod::previous})
    for (const Accommodation& mode : {Accommodation(RelaxedAccommodation{}), Accommodation(BestAccommodation{2.0})}) {
      const Eye eye = eye_with(mode);
      FieldGrid grid = small;
      grid.nz = 150;  // more than two words of the mask
      const TracedDirections directions = trace_directions(&lens, center, grid);
      VoxelMask mask(grid);
      struct Place {
        double x, y, vergence;
      };
      const Place places[] = {
          {0.1, 0.2, 1.1}, {-0.9, 0.99, 3.9}, {1.0, -1.0, 0.0}, {0.11, 0.2, 1.105}, {0.1, 0.2, 2.5}};
      for (const Place& p : places) mask.add_look_up(p.x, p.y, p.vergence);
      mask.add_look_up(2.0, 0.0, 1.0);  // outside: nothing
      EXPECT_LE(mask.count(), 40u);
      const VoxelField all = fill_voxels(&lens, eye, grid, directions, method),
                       some = fill_voxels(&lens, eye, grid, directions, method, &mask);
      EXPECT_EQ(some.stored_voxels(), mask.count());
      EXPECT_LT(some.memory_bytes(), all.memory_bytes() / 10);
      for (const Place& p : places)
        EXPECT_EQ(some.angular_footprint(p.x, p.y, p.vergence), all.angular_footprint(p.x, p.y, p.vergence));
      EXPECT_TRUE(some.angular_footprint(0.1, 0.2, 1.1));
      EXPECT_FALSE(some.angular_footprint(0.5, 0.5, 1.1));
    }
}

TEST(TracedDirections, OneQuadrantOfASymmetricLensIsEnough) {
  FieldGrid even = small;
  even.nx = 6;
  even.ny = 4;
  for (const FieldGrid& grid : {small, even})
    for (const LensCase& c : lenses()) {
      const TracedDirections all = trace_directions(&c.lens, center, grid, {.rim = true, .symmetry = false}),
                             quarter = trace_directions(&c.lens, center, grid);
      const bool symmetric = std::string(c.name) == "sphere" || std::string(c.name) == "upright toric";
      EXPECT_EQ(has_two_mirrors(c.lens), symmetric) << c.name;
      EXPECT_EQ(all.counters.mirrored, 0u);
      if (symmetric) {
        EXPECT_EQ(quarter.counters.traced, static_cast<std::uint64_t>((grid.nx + 1) / 2 * ((grid.ny + 1) / 2)));
        EXPECT_EQ(quarter.counters.traced + quarter.counters.mirrored, grid.directions());
      } else {
        EXPECT_EQ(quarter.counters.mirrored, 0u);
      }
      for (std::size_t d = 0; d < grid.directions(); ++d) {
        const SpectacleConoid &a = all.conoids[d], &b = quarter.conoids[d];
        ASSERT_EQ(a.status, b.status);
        // The same operations with other signs; sums in another order round differently.
        EXPECT_LT((a.chief_ray.origin - b.chief_ray.origin).norm(), 1e-16) << c.name;
        EXPECT_LT((a.chief_ray.direction - b.chief_ray.direction).norm(), 1e-15) << c.name;
        EXPECT_LT((a.exit.e1 - b.exit.e1).norm() + (a.exit.e2 - b.exit.e2).norm(), 1e-15) << c.name;
        EXPECT_LT((a.angular_p(2.0) - b.angular_p(2.0)).norm() + (a.angular_q(2.0) - b.angular_q(2.0)).norm(), 1e-13)
            << c.name;
      }
    }
}

TEST(TracedDirections, WhatIsBeyondTheRimNeedNoTracing) {
  for (LensCase& c : lenses()) {
    c.lens.diameter_m = 24e-3;
    const TracedDirections all = trace_directions(&c.lens, center, small, {.rim = false, .symmetry = false}),
                           inner = trace_directions(&c.lens, center, small, {.rim = true, .symmetry = false});
    EXPECT_EQ(all.counters.beyond_rim, 0u);
    EXPECT_GT(inner.counters.beyond_rim, 0u) << c.name;
    EXPECT_EQ(inner.counters.beyond_rim + inner.counters.traced, small.directions());
    EXPECT_EQ(inner.counters.usable, all.counters.usable);
    EXPECT_EQ(inner.counters.usable + inner.counters.missed_lens, small.directions());
    for (std::size_t d = 0; d < small.directions(); ++d) {
      ASSERT_EQ(inner.conoids[d].status, all.conoids[d].status) << c.name;
      if (all.conoids[d].status == LensStatus::ok) {
        EXPECT_EQ(inner.conoids[d].angular_q(1.0), all.conoids[d].angular_q(1.0));
      }
    }
  }
}

TEST(TracedDirections, OfTheNakedEye) {
  const Eye eye = eye_with(BestAccommodation{2.0});
  const TracedDirections directions = trace_directions(nullptr, center, small);
  EXPECT_EQ(directions.counters.usable, small.directions());
  const VoxelField field = fill_voxels(nullptr, eye, small, directions);
  const double vergence = 3.0;
  const Footprint exact = naked_eye_footprint(eye, 1.0 / vergence);
  EXPECT_LT((field.angular_footprint(0.4, 0.3, vergence)->cast<double>() - exact.angular).norm(), 1e-5);
}

TEST(FieldExr, ReadsBackWhatWasWritten) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "sturm_conoid_field.exr";
  Spectacles lens = single_vision({-4.0, -2.0, 30.0}, {});
  lens.diameter_m = 24e-3;  // some directions miss it
  const Eye eye = eye_with(RelaxedAccommodation{});
  const TracedDirections directions = trace_directions(&lens, center, small);
  const DepthAnalyticField analytic(small, directions, eye.correction);
  VoxelMask mask(small);
  for (const double x : {-0.95, 0.0, 0.3}) mask.add_look_up(x, 0.1, 1.3);
  for (const VoxelMask* visible : {static_cast<const VoxelMask*>(nullptr), static_cast<const VoxelMask*>(&mask)}) {
    const VoxelField voxels = fill_voxels(&lens, eye, small, directions, FieldMethod::ray_transfer, visible);
    write_blur_field(file, small, directions, &analytic, &voxels, {{"note", "x"}});
    const StoredBlurField read = read_blur_field(file);
    EXPECT_EQ(read.grid, small);
    EXPECT_EQ(read.metadata, (std::map<std::string, std::string>{{"note", "x"}}));
    ASSERT_EQ(read.chief_rays.size(), small.directions());
    for (std::size_t d = 0; d < small.directions(); ++d) {
      ASSERT_EQ(read.chief_rays[d].status, directions.conoids[d].status);
      if (read.chief_rays[d].status == LensStatus::ok) {
        EXPECT_LT((read.chief_rays[d].ray.direction - directions.conoids[d].chief_ray.direction).norm(), 2 * single);
      }
    }
    ASSERT_TRUE(read.analytic && read.voxels);
    EXPECT_EQ(read.voxels->sparse(), visible != nullptr);
    EXPECT_EQ(read.voxels->stored_voxels(), voxels.stored_voxels());
    EXPECT_EQ(read.voxels->undefined_count(), voxels.undefined_count());
    for (const double x : {-0.95, 0.0, 0.3, 0.9}) {
      EXPECT_EQ(read.analytic->angular_footprint(static_cast<float>(x), 0.1f, 1.3f, 0.0f),
                analytic.angular_footprint(static_cast<float>(x), 0.1f, 1.3f, 0.0f));
      EXPECT_EQ(read.voxels->angular_footprint(x, 0.1, 1.3), voxels.angular_footprint(x, 0.1, 1.3));
    }
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace sturm
