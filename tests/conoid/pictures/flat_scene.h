#pragma once
#include <Eigen/Core>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "conoid/pictures/multipass.h"
#include "conoid/pictures/sight_field.h"
#include "io/images/fragment_image.h"

namespace sturm {

/// Cards across the z axis in front of an eye at the origin, each with a colour that is a function of the place on it;
/// for tests of predicted pictures, whose oracle asks the same cards by arithmetic alone.
struct Card {
  double z, x0, x1, y0, y1;
  std::function<double(double x, double y)> radiance;
  bool lamp = false;  // whether it counts as a lamp
};

class FlatScene {
 public:
  explicit FlatScene(std::vector<Card> cards) : cards_(std::move(cards)) {}

  FirstHits first_hits() const {
    return [this](std::span<const SeenRay> rays, float from_m, std::span<FirstHit> hits) {
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const Eigen::Vector3d origin = rays[i].origin.cast<double>(), direction = rays[i].direction.cast<double>();
        Eigen::Vector3d at;
        const Card* card = first(origin, direction, at, static_cast<double>(from_m) / direction.norm());
        hits[i] = card ? FirstHit{static_cast<float>((at - origin).norm() / direction.norm()), card->lamp} : FirstHit{};
      }
    };
  }

  /// The card that a ray meets first behind `from`, in units of its direction, and where; null for the black
  /// surroundings.
  const Card* first(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, Eigen::Vector3d& at,
                    double from = 0.0) const {
    const Card* nearest = nullptr;
    double best = std::numeric_limits<double>::infinity();
    for (const Card& c : cards_) {
      const double t = (c.z - origin.z()) / direction.z();
      const Eigen::Vector3d p = origin + t * direction;
      if (!(t > from && t < best && p.x() >= c.x0 && p.x() <= c.x1 && p.y() >= c.y0 && p.y() <= c.y1)) continue;
      best = t;
      nearest = &c;
      at = p;
    }
    return nearest;
  }
  double radiance(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
    Eigen::Vector3d at;
    const Card* card = first(origin, direction, at);
    return card ? card->radiance(at.x(), at.y()) : 0.0;
  }

  /// The sharp view along the field's chief rays, 4 × 4 samples per pixel.
  FragmentImage sharp_view(const SightField& field, int oversampling = 1) const {
    const int width = field.plane().width * oversampling, height = field.plane().height * oversampling;
    FragmentImage view{width, height, {0}, {}};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        std::vector<const Card*> cards;
        const std::size_t first_fragment = view.fragments.size();
        for (int k = 0; k < 16; ++k) {
          const Eigen::Vector2d place((x + (k % 4 + 0.5) / 4) / oversampling, (y + (k / 4 + 0.5) / 4) / oversampling);
          const auto chief = field.chief_ray(place);
          if (!chief) continue;
          Eigen::Vector3d at = chief->direction.normalized();
          const Card* card = first(chief->origin, chief->direction, at);
          std::size_t i = 0;
          while (i < cards.size() && cards[i] != card) ++i;
          if (i == cards.size()) {
            cards.push_back(card);
            Fragment f{};
            f.position = f.radiance = f.direct = f.albedo = f.direct_variance = f.indirect_variance =
                Eigen::Vector3f::Zero();
            f.normal = card ? Eigen::Vector3f(Eigen::Vector3f::UnitZ()) : Eigen::Vector3f(Eigen::Vector3f::Zero());
            f.middle.setZero();
            f.spread.setZero();
            f.surroundings = !card;
            f.emits = card && card->lamp;
            f.lambertian = card;
            view.fragments.push_back(f);
          }
          Fragment& f = view.fragments[first_fragment + i];
          f.share += 1.0f / 16;
          const Eigen::Vector2f within((k % 4 + 0.5f) / 4, (k / 4 + 0.5f) / 4);
          f.middle += within;
          f.spread += Eigen::Vector3f(within.x() * within.x(), within.x() * within.y(), within.y() * within.y());
          f.position += at.cast<float>();
          f.radiance += Eigen::Vector3f::Constant(card ? static_cast<float>(card->radiance(at.x(), at.y())) : 0.0f);
        }
        for (std::size_t i = first_fragment; i < view.fragments.size(); ++i) {
          Fragment& f = view.fragments[i];
          f.position /= 16.0f * f.share;
          f.middle /= 16.0f * f.share;
          // A sample stands for a sixteenth of the pixel, whose own variance is (1/4)²/12.
          const Eigen::Vector3f square(f.middle.x() * f.middle.x(), f.middle.x() * f.middle.y(),
                                       f.middle.y() * f.middle.y());
          f.spread = f.spread / (16.0f * f.share) - square + Eigen::Vector3f(1.0f, 0.0f, 1.0f) / 192.0f;
          f.radiance /= 16.0f * f.share;
          if (f.surroundings) f.position.normalize();
        }
        view.first.push_back(static_cast<std::uint32_t>(view.fragments.size()));
      }
    return view;
  }

  PlaceShader shader() const {
    return [this](const UnseenPlaces& places) {
      std::vector<Eigen::Vector3f> result;
      for (std::size_t k = 0; k < places.count(); ++k) {
        double sum = 0.0;
        for (std::uint32_t i = places.first[k]; i < places.first[k + 1]; ++i)
          sum += radiance(places.rays[i].origin.cast<double>(), places.rays[i].direction.cast<double>());
        result.push_back(Eigen::Vector3f::Constant(static_cast<float>(sum / (places.first[k + 1] - places.first[k]))));
      }
      return result;
    };
  }

 private:
  std::vector<Card> cards_;
};

}  // namespace sturm
