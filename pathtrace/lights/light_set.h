#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "pathtrace/lights/environment_map.h"
#include "pathtrace/lights/light_groups.h"

namespace sturm {

/// A direction towards a light, sampled at a point that it may illuminate.
struct LightSample {
  Eigen::Vector3f direction;  ///< from the point to the light, not normalised: t = 1 is the sampled point
  float distance;             ///< length of `direction` [m]
  Eigen::Vector3f radiance;   ///< emitted towards the point; for a point light: intensity / distance²
  float pdf;       ///< per solid angle, choice of the light included; for a point light: probability of the choice
  bool delta;      ///< cannot be hit by chance
  int group = -1;  ///< ≥ 0: the direction is drawn in the cone of this group (LightGroup::round); `radiance` is that of
                   ///< whatever light of the group a ray meets first there, and not known before
  int varying = -1;  ///< ≥ 0: this light varies over its surface or has holes; `radiance` is what a ray meets of it
};

/// Where a light is: three corners of a triangle, or centre and radius of a sphere; a point light has neither corners
/// nor radius.
struct LightShape {
  std::vector<Eigen::Vector3f> corners;
  Eigen::Vector3f center;
  float radius = 0.0f;
  Eigen::Vector3f emission;             ///< radiance; of a point light its intensity
  bool behind = false, varies = false;  ///< see TriangleTraits
};

struct TriangleTraits {
  bool behind = false;  ///< the other side of a triangle that is a light already; hangs together only with such
  bool varies = false;  ///< its radiance is a mean, for the choice among lights; the scene knows what a ray meets
};

/// All lights of a scene. A group of them is chosen by what it could send to the point (LightGroups), then a light of
/// the group in proportion to its power, or a direction in the group's cone. What an environment map sends into a scene
/// depends on how large the scene is and says little about any one point, so beside other lights it gets half of all
/// choices.
class LightSet {
 public:
  int add_triangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                   const Eigen::Vector3f& radiance, const TriangleTraits& traits = {});
  int add_sphere(const Eigen::Vector3f& center, float radius, const Eigen::Vector3f& radiance);
  int add_point(const Eigen::Vector3f& position, const Eigen::Vector3f& intensity);

  /// `reach` [m]: a distance from any point of the scene that lies outside of it.
  void set_environment(std::shared_ptr<const EnvironmentMap> environment, float reach);

  /// This light will never be chosen; what a path meets of it counts in full then, so the mean stays. Once for a light,
  /// before finish(); not for point lights, which no path meets.
  void leave_out(int light);

  /// Builds the groups; call once after the last light.
  void finish();

  /// True where there is nothing to choose.
  bool empty() const { return left_out_ == size() && !environment_; }
  int size() const { return static_cast<int>(lights_.size()); }
  LightShape shape(int light) const;

  /// Luminance of all that the light emits, π L A or 4π I.
  double power(int light) const { return power_[static_cast<std::size_t>(light)]; }

  /// The groups of `finish`.
  const LightGroups& groups() const { return groups_; }

  /// Samples a light for a surface at `point` that is lit from the side of its unit normal (0: from any side), from two
  /// uniform numbers; pdf = 0 where it cannot shine there (e.g. the back of a triangle).
  LightSample sample(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float u, float v) const;

  /// Density of `sample` for a ray that leaves the scene in this direction (of any length); 0 without an environment
  /// map.
  float environment_pdf(const Eigen::Vector3f& direction) const;

  /// Density of `sample` for a surface at `from` with normal `from_normal` and the direction of a ray that hit emitter
  /// `light` at `at` with unit normal `normal` there.
  float pdf(int light, const Eigen::Vector3f& from, const Eigen::Vector3f& from_normal, const Eigen::Vector3f& at,
            const Eigen::Vector3f& normal) const;

 private:
  enum class Kind : std::uint8_t { triangle, sphere, point };
  struct Light {
    Kind kind;
    Eigen::Vector3f a, edge1, edge2;  // triangle; sphere: a = centre, edge1.x = radius; point: a = position
    Eigen::Vector3f scaled_normal;    // triangle only: edge1 × edge2, of length 2·area
    Eigen::Vector3f emission;
    float area;   // triangle only
    float share;  // probability of being chosen from its group
    TriangleTraits traits{};
  };
  static LightSample sample_triangle(const Light& light, float probability, const Eigen::Vector3f& point, float u,
                                     float v);
  static LightSample sample_sphere(const Light& light, float probability, const Eigen::Vector3f& point, float u,
                                   float v);

  std::vector<Light> lights_;
  std::vector<double> power_;
  int left_out_ = 0;
  LightGroups groups_;
  std::shared_ptr<const EnvironmentMap> environment_;
  float reach_ = 0.0f, environment_share_ = 0.0f, lights_share_ = 0.0f;  ///< the shares of all choices
};

}  // namespace sturm
