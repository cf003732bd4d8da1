#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "lensmodel/progressive_surface.h"
#include "lensmodel/surface_power.h"
#include "support/source_folder.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::mm;

/// The surface of tests/reference/pal_circular_section_reference.csv.
ProgressiveSurfaceDesign reference_design() {
  ProgressiveSurfaceDesign design;
  design.far_power_D = 6.0;
  design.addition_D = 2.0;
  design.refractive_index = 1.498;
  design.corridor_length_m = 14 * mm;
  return design;
}

struct ReferenceRow {
  double x_mm, y_mm, sag_mm, mean_D, cyl_D;
};

std::vector<ReferenceRow> reference_rows() {
  std::ifstream in(std::string(STURM_SOURCE_DIR) + "/tests/reference/pal_circular_section_reference.csv");
  std::vector<ReferenceRow> rows;
  for (std::string line; std::getline(in, line);) {
    ReferenceRow row{};
    char comma = 0;
    if (std::istringstream text(line);
        text >> row.x_mm >> comma >> row.y_mm >> comma >> row.sag_mm >> comma >> row.mean_D >> comma >> row.cyl_D)
      rows.push_back(row);
  }
  return rows;
}

TEST(ProgressiveSurface, AgreesWithTheReferenceGrid) {
  const ProgressiveSurface surface(reference_design());
  const auto rows = reference_rows();
  ASSERT_EQ(rows.size(), 91u);
  for (const ReferenceRow& row : rows)
    for (const double side : {-1.0, 1.0}) {
      // The file's x runs down from the fitting cross, its y sideways.
      const auto sag = surface.sag(side * row.y_mm * mm, -row.x_mm * mm);
      ASSERT_TRUE(sag);
      const SurfacePower power = surface_power(*sag, 1.498);
      EXPECT_NEAR(sag->value / mm, row.sag_mm, 0.5001e-6) << row.x_mm << " " << row.y_mm;  // printed to 6 digits
      EXPECT_NEAR(power.mean_D, row.mean_D, 0.51e-5) << row.x_mm << " " << row.y_mm;       // printed to 5 digits
      EXPECT_NEAR(power.cylinder_D, row.cyl_D, 0.51e-5) << row.x_mm << " " << row.y_mm;
    }
}

/// Designs that use every parameter.
std::vector<ProgressiveSurfaceDesign> designs() {
  ProgressiveSurfaceDesign turned{5.5, 3.0, 1.5, 4 * mm, 18 * mm, -2.5 * mm, 10 * mm},
      low = turned, regressive = turned, minus = turned;
  low.corridor_start_m = -4 * mm;
  low.near_shift_m = 2.5 * mm;
  regressive.addition_D = -2.0;
  minus.far_power_D = -1.0;  // the umbilic goes through a flat place
  return {reference_design(), turned, low, regressive, minus};
}

TEST(ProgressiveSurface, DerivativesAreThoseOfTheHeight) {
  for (const ProgressiveSurfaceDesign& design : designs()) {
    const ProgressiveSurface surface(design);
    for (int i = -7; i <= 7; ++i)
      for (int j = -7; j <= 7; ++j) {
        const double x = 2.9 * mm * i, y = 2.9 * mm * j, h = 1e-5;
        const auto at = [&](double dx, double dy) { return *surface.sag(x + dx, y + dy); };
        const Eigen::Vector2d gradient((at(h, 0).value - at(-h, 0).value) / (2 * h),
                                       (at(0, h).value - at(0, -h).value) / (2 * h));
        Eigen::Matrix2d hessian;
        hessian.col(0) = (at(h, 0).gradient - at(-h, 0).gradient) / (2 * h);
        hessian.col(1) = (at(0, h).gradient - at(0, -h).gradient) / (2 * h);
        // h²/6 of the third derivative, up to 4e4 /m² in the corner of a circular section's corridor, and of the
        // fourth, up to 2e7 /m³.
        EXPECT_LE((gradient - at(0, 0).gradient).norm(), 1e4 * h * h);
        EXPECT_LE((hessian - at(0, 0).hessian).norm(), 5e6 * h * h);
      }
  }
}

TEST(ProgressiveSurface, TheUmbilicHasThePowerAndNoCylinder) {
  for (const ProgressiveSurfaceDesign& design : designs()) {
    const ProgressiveSurface surface(design);
    EXPECT_EQ(surface.sag(0.0, 0.0)->value, 0.0);
    EXPECT_EQ(surface.sag(0.0, 0.0)->gradient.norm(), 0.0);
    for (int i = -20; i <= 20; ++i) {
      const Eigen::Vector2d at = surface.umbilic_at(i * mm);
      const SurfacePower power = surface_power(*surface.sag(at.x(), at.y()), design.refractive_index);
      EXPECT_NEAR(power.mean_D, surface.umbilic_power_D(i * mm), 1e-13);
      EXPECT_NEAR(power.cylinder_D, 0.0, 1e-13);
    }
    const double start = -design.corridor_start_m, length = design.corridor_length_m;
    EXPECT_EQ(surface.umbilic_power_D(start), design.far_power_D);
    EXPECT_NEAR(surface.umbilic_power_D(start + 0.5 * length), design.far_power_D + 0.5 * design.addition_D, 1e-14);
    EXPECT_NEAR(surface.umbilic_power_D(start + length), design.far_power_D + design.addition_D, 1e-14);
    EXPECT_NEAR(surface.umbilic_at(start + length).x(), design.near_shift_m, 1e-18);
    EXPECT_LT(surface.umbilic_at(start + length).y(), 0.0);  // downwards
  }
}

TEST(ProgressiveSurface, TheFarZoneIsASphere) {
  const ProgressiveSurface surface(designs()[1]);
  for (int i = -5; i <= 5; ++i) {
    const SurfacePower power = surface_power(*surface.sag(4 * mm * i, 9 * mm + 1.5 * mm * std::abs(i)), 1.5);
    EXPECT_NEAR(power.mean_D, 5.5, 1e-13);
    EXPECT_NEAR(power.cylinder_D, 0.0, 1e-13);
  }
}

TEST(ProgressiveSurface, MinkwitzsTheoremHoldsOnTheUmbilic) {
  for (const ProgressiveSurfaceDesign& design : designs()) {
    const ProgressiveSurface surface(design);
    for (const double t : {0.2, 0.35, 0.5, 0.65, 0.8}) {
      const double s = -design.corridor_start_m + t * design.corridor_length_m, h = 0.01 * mm;
      const Sag here = *surface.sag(surface.umbilic_at(s).x(), surface.umbilic_at(s).y());
      const Eigen::Vector2d across = surface.umbilic_at(1.0).unitOrthogonal(),
                            beside = surface.umbilic_at(s) + h * across;
      const double cylinder = surface_power(*surface.sag(beside.x(), beside.y()), design.refractive_index).cylinder_D;
      // Along the umbilic one metre of arc is longer than its projection by √(1 + slope²); across it the surface is
      // level there.
      const double arc = std::sqrt(1.0 + here.gradient.squaredNorm());
      const double gain = (surface.umbilic_power_D(s + h) - surface.umbilic_power_D(s - h)) / (2 * h) / arc;
      EXPECT_NEAR(cylinder / h, 2.0 * std::abs(gain),
                  0.01 * 2.0 * std::abs(gain));  // linear in the distance up to O(h)
    }
  }
}

TEST(ProgressiveSurface, AFadingAdditionLeavesTheNeighbourhoodOfTheUmbilicAlone) {
  ProgressiveSurfaceDesign faded = reference_design();
  faded.zone_width_m = 10 * mm;
  const ProgressiveSurface circles(reference_design()), fading(faded);
  // Of fourth order: u⁴/(2 w²) · addition/(n − 1), here with u = 1 mm, in the near zone where cos ϑ = 0.95.
  const double near = circles.sag(1 * mm, -20 * mm)->value - fading.sag(1 * mm, -20 * mm)->value;
  EXPECT_NEAR(near, 1e-12 / (2 * 1.01e-4) * 2.0 / 0.498 / 0.956, 0.01 * near);
  // In the corridor's periphery it takes most of the cylinder away.
  const auto cylinder = [](const ProgressiveSurface& s) {
    return surface_power(*s.sag(20 * mm, -7 * mm), 1.498).cylinder_D;
  };
  EXPECT_GT(cylinder(circles), 13.0);
  EXPECT_LT(cylinder(fading), 4.0);
}

TEST(ProgressiveSurface, WhatMakesNoSurface) {
  ProgressiveSurfaceDesign bad = reference_design();
  bad.corridor_length_m = 0.0;
  EXPECT_THROW(ProgressiveSurface{bad}, std::invalid_argument);
  bad = reference_design();
  bad.refractive_index = 1.0;
  EXPECT_THROW(ProgressiveSurface{bad}, std::invalid_argument);
  bad = reference_design();
  bad.near_shift_m = 15 * mm;  // further to the side than down
  EXPECT_THROW(ProgressiveSurface{bad}, std::invalid_argument);
  bad = reference_design();
  bad.zone_width_m = 0.0;
  EXPECT_THROW(ProgressiveSurface{bad}, std::invalid_argument);
  EXPECT_FALSE(ProgressiveSurface(reference_design()).sag(90 * mm, 0.0));  // beyond the circle of 83 mm
}

}  // namespace
}  // namespace sturm
