// Materials one by one: sampling against density, density against the Jacobian of the sampling map, reciprocity,
// energy.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "pathtrace/materials/fresnel.h"
#include "pathtrace/materials/named_metals.h"
#include "pathtrace/materials/surface_model.h"
#include "support/units.h"

namespace sturm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using testing::pi;
const Vector3f grey(0.7f, 0.5f, 0.2f), white(1.0f, 1.0f, 1.0f);
const Vector3f no_eta(0.0f, 0.0f, 0.0f);

Vector3f direction(double theta, double phi) {
  return Vector3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)).cast<float>();
}

struct Case {
  std::string name;
  SurfaceModel model;
  Vector3f out;
};

/// Every kind with a continuous part, from above and (the last argument) from below.
std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const std::string& name, const SurfaceModel& model) {
    for (double theta : {0.0, 0.5, 1.3}) {
      all.push_back({name + " above " + std::to_string(theta), model, direction(theta, 0.7)});
      all.push_back({name + " below " + std::to_string(theta), model, direction(pi - theta, 2.1)});
    }
  };
  add("diffuse", Diffuse{});
  for (float roughness : {0.5f, 0.75f, 1.0f}) {
    add("conductor " + std::to_string(roughness), Conductor{{0.2f, 0.9f, 1.1f}, {3.9f, 2.4f, 2.1f}, roughness});
    add("dielectric " + std::to_string(roughness), Dielectric{1.5f, roughness});
    add("plastic " + std::to_string(roughness), Plastic(1.5f, roughness));
  }
  add("smooth plastic", Plastic(1.5f, 0.0f));
  add("seed_diffuse", SeedDiffuse{});
  for (float alpha : {0.4f, 1.0f}) add("seed_metal " + std::to_string(alpha), SeedMetal{alpha});
  return all;
}

/// Upper tail of χ² with k degrees of freedom as a normal deviate (Wilson & Hilferty 1931; error below 0.02 for k >
/// 30).
double normal_deviate(double chi_squared, double k) {
  return (std::cbrt(chi_squared / k) - (1.0 - 2.0 / (9.0 * k))) / std::sqrt(2.0 / (9.0 * k));
}

TEST(MaterialSampling, SlowFollowsTheDensity) {
  // 72² points a bin: densities have square-root edges (ball lobes) and poles (refraction near the critical angle).
  constexpr int rows = 16, columns = 24, fine = 72, n = 1 << 17;
  const auto all = cases();
  std::mt19937_64 random(20250801);
  std::uniform_real_distribution<float> uniform(0.0f, std::nextafter(1.0f, 0.0f));
  // 1 % for the whole family: Šidák's level for each of 84 tests is 1 − 0.99^(1/84) = 1.2e−4, one-sided normal
  // deviate 3.67.
  ASSERT_EQ(all.size(), 84u);
  constexpr double largest_deviate = 3.67;
  for (const Case& c : all) {
    std::vector<double> expected(rows * columns + 1, 0.0), seen(rows * columns + 1, 0.0);
    double mass = 0.0;
    for (int i = 0; i < rows * fine; ++i)
      for (int j = 0; j < columns * fine; ++j) {
        const double theta = pi * (i + 0.5) / (rows * fine), phi = 2.0 * pi * (j + 0.5) / (columns * fine) - pi;
        const double p = static_cast<double>(evaluate(c.model, c.out, direction(theta, phi), grey).pdf) *
                         std::sin(theta) * 2.0 * pi * pi / (static_cast<double>(rows) * columns * fine * fine);
        expected[(i / fine) * columns + j / fine] += p * n;
        mass += p;
      }
    expected.back() = (1.0 - mass) * n;  // sharp, or absorbed
    EXPECT_LT(mass, 1.0 + 2e-3) << c.name;
    for (int k = 0; k < n; ++k) {
      const float u = uniform(random), v = uniform(random), lobe = uniform(random);
      const BsdfSample s = sample(c.model, c.out, {u, v, lobe}, grey);
      if (s.delta || !(s.pdf > 0.0f)) {
        ++seen.back();
        continue;
      }
      ASSERT_NEAR(s.in.norm(), 1.0f, 1e-5f) << c.name;
      const double theta = std::atan2(std::hypot(static_cast<double>(s.in.x()), static_cast<double>(s.in.y())),
                                      static_cast<double>(s.in.z()));
      const int row = std::min(rows - 1, static_cast<int>(theta / pi * rows));
      const double turn = (std::atan2(static_cast<double>(s.in.y()), static_cast<double>(s.in.x())) + pi) / (2.0 * pi);
      ++seen[row * columns + std::min(columns - 1, static_cast<int>(turn * columns))];
    }
    double chi_squared = 0.0, pooled_expected = 0.0, pooled_seen = 0.0;
    int bins = 0;
    const auto count = [&](double e, double o) {
      chi_squared += (o - e) * (o - e) / e;
      ++bins;
    };
    for (std::size_t b = 0; b < seen.size(); ++b) {
      if (expected[b] >= 20.0) {
        count(expected[b], seen[b]);
      } else {
        pooled_expected += expected[b];
        pooled_seen += seen[b];
      }
    }
    if (pooled_expected >= 20.0) count(pooled_expected, pooled_seen);
    EXPECT_LT(normal_deviate(chi_squared, bins - 1), largest_deviate)
        << c.name << ": chi² " << chi_squared << " of " << bins << " bins";
  }
}

TEST(MaterialSampling, WeightTimesDensityIsTheValue) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<float> uniform(0.0f, 0.999999f);
  for (const Case& c : cases())
    for (int k = 0; k < 500; ++k) {
      const float u = uniform(random), v = uniform(random), lobe = uniform(random);
      const BsdfSample s = sample(c.model, c.out, {u, v, lobe}, grey);
      if (s.delta || !(s.pdf > 0.0f)) continue;
      const BsdfValue at = evaluate(c.model, c.out, s.in, grey);
      // Rounding of the lobe's argument: 1e−6 rad against widths of 0.1 rad and more.
      ASSERT_NEAR(s.pdf, at.pdf, 2e-3f * at.pdf + 1e-5f) << c.name;
      for (int i = 0; i < 3; ++i) ASSERT_NEAR(s.weight[i] * s.pdf, at.value[i], 2e-3f * at.value[i] + 1e-5f) << c.name;
    }
}

constexpr float difference = 1e-3f;

/// |∂in/∂u × ∂in/∂v| by central differences.
double jacobian(const SurfaceModel& model, const Vector3f& out, float u, float v, float lobe) {
  constexpr float h = difference;
  const auto at = [&](float du, float dv) {
    return Vector3d(sample(model, out, {u + du, v + dv, lobe}, grey).in.cast<double>());
  };
  const Vector3d along_u = (at(h, 0) - at(-h, 0)) / (2.0 * static_cast<double>(h));
  const Vector3d along_v = (at(0, h) - at(0, -h)) / (2.0 * static_cast<double>(h));
  return along_u.cross(along_v).norm();
}

// No noise and no seed: where a single lobe maps the unit square to directions, its area element is 1/pdf. For the
// dielectric the density holds the probability of the lobe, so that area · pdf is F or 1 − F of the facet.
TEST(MaterialSampling, AreaElementIsOneOverTheDensity) {
  const float us[] = {0.12f, 0.37f, 0.81f}, vs[] = {0.23f, 0.55f, 0.71f};
  int checked = 0;
  const auto check = [&](const SurfaceModel& model, const Vector3f& out, float u, float v, float lobe,
                         const auto& probability) {
    const BsdfSample s = sample(model, out, {u, v, lobe}, grey);
    if (!(s.pdf > 0.0f)) return;
    for (const auto& [du, dv] :
         {std::pair{difference, 0.0f}, {-difference, 0.0f}, {0.0f, difference}, {0.0f, -difference}}) {
      const BsdfSample beside = sample(model, out, {u + du, v + dv, lobe}, grey);
      if (!(beside.pdf > 0.0f) || beside.in.z() * s.in.z() < 0.0f) return;  // the lobe ends here
    }
    const double expected = probability(s.in);
    // O(h²) of the differences with h = 1e−3 (measured below 2e−3), rounding 6e−8/h.
    EXPECT_NEAR(jacobian(model, out, u, v, lobe) * static_cast<double>(s.pdf), expected, 5e-3 * expected)
        << u << ' ' << v;
    ++checked;
  };
  const auto certain = [](const Vector3f&) { return 1.0; };
  for (float u : us)
    for (float v : vs)
      for (double theta : {0.1, 0.8, 1.2}) {
        const Vector3f out = direction(theta, 0.4);
        check(Diffuse{}, out, u, v, 0.0f, certain);
        for (float roughness : {0.3f, 0.6f, 1.0f}) {
          check(Conductor{no_eta, white, roughness}, out, u, v, 0.0f, certain);
          for (const Vector3f& from : {out, Vector3f(-out)}) {
            const float eta = from.z() > 0.0f ? 1.5f : 1.0f / 1.5f;
            check(Dielectric{1.5f, roughness}, from, u, v, 0.0f, [&](const Vector3f& in) {
              const Vector3f h = (from + in).normalized();
              return static_cast<double>(fresnel_dielectric(std::abs(from.dot(h)), eta).reflectance);
            });
            // Towards total reflection the derivative of Snell's law grows without bound: no finite difference holds
            // there.
            const BsdfSample passed = sample(Dielectric{1.5f, roughness}, from, {u, v, 0.999f}, grey);
            if (!(passed.in.dot((from + eta * passed.in).normalized()) * (eta > 1.0f ? -1.0f : 1.0f) < -0.4f) &&
                passed.in.z() * from.z() < 0.0f)
              continue;
            check(Dielectric{1.5f, roughness}, from, u, v, 0.999f, [&](const Vector3f& in) {
              const bool through = in.z() * from.z() < 0.0f;
              const Vector3f h = (through ? Vector3f(from + eta * in) : Vector3f(from + in)).normalized();
              const double f = static_cast<double>(fresnel_dielectric(std::abs(from.dot(h)), eta).reflectance);
              return through ? 1.0 - f : f;
            });
          }
        }
      }
  EXPECT_GT(checked, 300);
}

TEST(Materials, AreReciprocal) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0.05, 0.95);
  const std::vector<SurfaceModel> models{Diffuse{}, Conductor{{0.2f, 0.9f, 1.1f}, {3.9f, 2.4f, 2.1f}, 0.6f},
                                         Dielectric{1.5f, 0.8f}, Plastic(1.5f, 0.6f), Plastic(1.5f, 0.0f)};
  for (std::size_t m = 0; m < models.size(); ++m) {
    int through = 0;
    for (int k = 0; k < 2000; ++k) {
      const Vector3f a = direction(std::acos(2.0 * uniform(random) - 1.0), 6.28 * uniform(random));
      const Vector3f b = direction(std::acos(2.0 * uniform(random) - 1.0), 6.28 * uniform(random));
      const float ab = evaluate(models[m], a, b, grey).value[1] / std::abs(b.z()),
                  ba = evaluate(models[m], b, a, grey).value[1] / std::abs(a.z());
      // Radiance over n²: [Veach1997, eq. 5.14].
      const float n2 = std::holds_alternative<Dielectric>(models[m]) ? 2.25f : 1.0f;
      const float left = ab / (a.z() > 0.0f ? 1.0f : n2), right = ba / (b.z() > 0.0f ? 1.0f : n2);
      EXPECT_NEAR(left, right, 1e-4f * std::max(left, right) + 1e-6f)
          << m;  // rounding, of half vectors at grazing angles most
      through += left > 0.0f && a.z() * b.z() < 0.0f;
    }
    EXPECT_EQ(through > 0, std::holds_alternative<Dielectric>(models[m]));
  }
  // The seed's are not.
  const Vector3f a = direction(0.2, 0.0), b = direction(1.2, pi);
  EXPECT_GT(evaluate(SeedDiffuse{}, b, a, grey).value[0] / a.z(),
            5.0f * evaluate(SeedDiffuse{}, a, b, grey).value[0] / b.z());
}

/// Reflected and transmitted share of unit radiance from everywhere (inside a body of index n: n²): the mean weight of
/// 2^18 samples.
double furnace(const SurfaceModel& model, const Vector3f& out, const Vector3f& albedo, double index = 1.0) {
  constexpr int n = 1 << 18;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, std::nextafter(1.0f, 0.0f));
  double sum = 0.0;
  const double n2 = index * index, here = out.z() > 0.0f ? 1.0 : n2;
  for (int i = 0; i < n; ++i) {
    const float u = uniform(random), v = uniform(random), lobe = uniform(random);
    const BsdfSample s = sample(model, out, {u, v, lobe}, albedo);
    if (s.pdf > 0.0f) sum += static_cast<double>(s.weight[0]) * (s.in.z() > 0.0f ? 1.0 : s.in.z() < 0.0f ? n2 : 0.0);
  }
  return sum / n / here;
}

TEST(MaterialFurnace, SmoothAndDiffuseConserveEnergy) {
  for (double theta : {0.0, 0.6, 1.2, 1.5}) {
    const Vector3f out = direction(theta, 0.3);
    EXPECT_NEAR(furnace(Diffuse{}, out, white), 1.0, 1e-6);
    EXPECT_NEAR(furnace(Conductor{no_eta, white, 0.0f}, out, white), 1.0, 1e-6);
    // Inside and outside: what is transmitted has n² times the radiance on its side. 1/64: the grid's step of the
    // choice of a lobe.
    for (const Vector3f& from : {out, Vector3f(-out)})
      EXPECT_NEAR(furnace(Dielectric{1.5f, 0.0f}, from, white, 1.5), 1.0, 1e-5) << theta;
    // 4σ: the weights of coat and base differ by at most 0.7 near grazing incidence, 0.35/√2^18.
    EXPECT_NEAR(furnace(Plastic(1.5f, 0.0f), out, white), 1.0, 3e-3) << theta;
    EXPECT_NEAR(furnace(SeedDiffuse{}, out, white), 1.0, 1e-6);
  }
}

/// Directional albedo of white GGX without multiple reflection in double: ∫ D G₂ / (4 cos θ_out) dω_in over the half
/// vector's angles.
double single_scattering_albedo(double alpha, double theta) {
  const Vector3d out(std::sin(theta), 0.0, std::cos(theta));
  const auto lambda = [&](const Vector3d& w) {
    const double t = std::tan(std::acos(std::min(1.0, w.z())));
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * t * t) - 1.0);
  };
  double sum = 0.0;
  constexpr int n = 800, m = 400;
  for (int i = 0; i < n; ++i) {
    // tan θ_h = α √(ξ/(1 − ξ)) has equal shares of D cos θ_h; ξ = 1 − w² makes the tail finite.
    const double w = (i + 0.5) / n, tangent = alpha * std::sqrt(1.0 - w * w) / w,
                 cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
    for (int j = 0; j < m; ++j) {
      const double phi = 2.0 * pi * (j + 0.5) / m, sine = tangent * cosine;
      const Vector3d h(sine * std::cos(phi), sine * std::sin(phi), cosine);
      const double oh = out.dot(h);
      const Vector3d in = 2.0 * oh * h - out;
      if (oh <= 0.0 || in.z() <= 0.0) continue;
      // f cos θ_in dω_in = D G₂ / (4 cos θ_out) · 4 (out·h) dω_h
      sum += 2.0 * w * oh / (out.z() * cosine) / (1.0 + lambda(out) + lambda(in));
    }
  }
  return sum / (static_cast<double>(n) * m);
}

TEST(MaterialFurnace, RoughMetalLosesWhatWouldScatterTwice) {
  for (float roughness : {0.3f, 0.6f, 0.8f, 1.0f})
    for (double theta : {0.1, 0.8, 1.3}) {
      const double expected =
          single_scattering_albedo(static_cast<double>(roughness) * static_cast<double>(roughness), theta);
      const double measured = furnace(Conductor{no_eta, white, roughness}, direction(theta, 0.3), white);
      EXPECT_NEAR(measured, expected, 4e-3) << roughness << ' ' << theta;  // 4σ = 4 · 0.5/√2^18
      EXPECT_LE(measured, 1.0 + 1e-5);
      RecordProperty("white_metal_" + std::to_string(roughness) + "_" + std::to_string(theta),
                     std::to_string(measured));
    }
}

TEST(MaterialFurnace, SlowNothingGainsEnergy) {
  for (const Case& c : cases()) {
    const double index = std::holds_alternative<Dielectric>(c.model) ? 1.5 : 1.0;
    const double total = furnace(c.model, c.out, white, index);
    EXPECT_LT(total, 1.01) << c.name;  // a rough coat adds at most 1 % to what it should (docs/theory.md#93-estimators)
    EXPECT_GT(total, 0.25) << c.name;
  }
}

TEST(Fresnel, Literals) {
  EXPECT_NEAR(fresnel_dielectric(1.0f, 1.5f).reflectance, 0.04f, 1e-7f);
  EXPECT_NEAR(fresnel_dielectric(1.0f, 1.0f / 1.5f).reflectance, 0.04f, 1e-7f);
  // At Brewster's angle atan 1.5 the parallel part vanishes: ½ ((n² − 1)/(n² + 1))² = ½ (5/13)².
  EXPECT_NEAR(fresnel_dielectric(0.5547002f, 1.5f).reflectance, 0.0739645f, 1e-6f);
  EXPECT_NEAR(fresnel_dielectric(0.5547002f, 1.5f).cosine_in, 0.8320503f, 1e-6f);
  EXPECT_EQ(fresnel_dielectric(0.0f, 1.5f).reflectance, 1.0f);
  // From inside: total beyond asin(2/3), whose cosine is 0.745356.
  EXPECT_EQ(fresnel_dielectric(0.745f, 1.0f / 1.5f).reflectance, 1.0f);
  EXPECT_LT(fresnel_dielectric(0.746f, 1.0f / 1.5f).reflectance, 0.9f);
  EXPECT_NEAR(fresnel_schlick(1.0f, 0.2f), 0.2f, 1e-7f);
  EXPECT_NEAR(fresnel_schlick(0.5f, 0.2f), 0.225f, 1e-7f);
}

TEST(Fresnel, ConductorAgainstComplexArithmetic) {
  const NamedMetal& gold = named_metals[0];
  ASSERT_EQ(gold.name, "gold");
  const Vector3f eta(gold.eta.data()), kappa(gold.kappa.data());
  // Literals: Fresnel's amplitudes in complex arithmetic (python3 cmath) at cos θ = 1, 0.5 and 0.1.
  const float expected[3][3] = {
      {0.9666628f, 0.8021901f, 0.3240495f}, {0.9621918f, 0.8045416f, 0.3710980f}, {0.9734199f, 0.9195709f, 0.7188285f}};
  const float cosines[] = {1.0f, 0.5f, 0.1f};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(fresnel_conductor(cosines[i], eta, kappa)[k], expected[i][k], 2e-6f) << i << k;
  // Without absorption a conductor is a dielectric.
  for (float cosine : {0.1f, 0.5f, 0.9f})
    EXPECT_NEAR(fresnel_conductor(cosine, Vector3f::Constant(1.5f), no_eta)[0],
                fresnel_dielectric(cosine, 1.5f).reflectance, 1e-6f);
}

TEST(Materials, NamedMetalsLookLikeThemselves) {
  // Reflectance at normal incidence in air, from tables of polished metals: all of them bright in red, gold and copper
  // dark in blue.
  for (const NamedMetal& metal : named_metals) {
    const Vector3f r = fresnel_conductor(1.0f, Vector3f(metal.eta.data()), Vector3f(metal.kappa.data()));
    EXPECT_GT(r.x(), 0.88f) << metal.name;
    const bool coloured = metal.name == "gold" || metal.name == "copper";
    EXPECT_EQ(r.z() < 0.6f, coloured) << metal.name;
    EXPECT_GT(r.y(), r.z() - 0.02f) << metal.name;
  }
}

TEST(Plastic, InternalReflectance) {
  EXPECT_NEAR(Plastic(1.5f).internal_reflectance(), 0.5963f,
              2e-4f);  // [Walsh1926] in Duntley's table for 1.5: 1 − (1 − 0.0918)/1.5²
}

TEST(Dielectric, RefractsBySnellOnTheRightSide) {
  // 30° in air at index 1.5: sin θ' = 1/3, on the other side of the normal.
  const BsdfSample in = sample(Dielectric{1.5f, 0.0f}, {0.5f, 0.0f, 0.8660254f}, {0.0f, 0.0f, 0.999f}, white);
  EXPECT_NEAR(in.in.x(), -1.0f / 3.0f, 1e-6f);
  EXPECT_NEAR(in.in.z(), -0.9428090f, 1e-6f);
  EXPECT_NEAR(in.weight.x(), 1.0f / 2.25f, 1e-6f);
  const BsdfSample back = sample(Dielectric{1.5f, 0.0f}, {1.0f / 3.0f, 0.0f, -0.9428090f}, {0.0f, 0.0f, 0.999f}, white);
  EXPECT_NEAR(back.in.x(), -0.5f, 1e-6f);
  EXPECT_NEAR(back.in.z(), 0.8660254f, 1e-6f);
  EXPECT_NEAR(back.weight.x(), 2.25f, 1e-5f);
}

}  // namespace
}  // namespace sturm
