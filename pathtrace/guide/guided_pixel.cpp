#include "pathtrace/guide/guided_pixel.h"

#include <numbers>

namespace sturm {

GuideUse SceneGuide::use() const {
  if (!(camera_.rays().pupil_radius() > 0.0f)) return GuideUse::no_pupil;
  if (camera_.rays().model() == RayModel::metalstigmatism) return GuideUse::dropped_rays;
  return empty() ? GuideUse::no_small_emitter : GuideUse::in_use;
}

GuidedPixel::GuidedPixel(const SceneGuide& guide, int x, int y, const PixelSequence& sequence)
    : guide_(guide), x_(x), y_(y), sequence_(sequence) {
  const float radius = guide.guide().pupil_radius();
  plain_pdf_ = 1.0f / (std::numbers::pi_v<float> * radius * radius);
  if (!guide.camera().is_sharp(x, y))
    guide.guide().find_targets(x, y, targets_);  // without points over the pupil there is nothing to guide
}

float GuidedPixel::share_of_plain(const GuidedTarget& target, float qx, float qy, float px, float py) const {
  return plain_pdf_ / (plain_pdf_ + target.probability * guide_.guide().pdf(target.cluster, qx, qy, px, py));
}

float GuidedPixel::plain_weight(int emitter, std::uint32_t sample) const {
  const int cluster = guide_.clusters().cluster_of(emitter);
  for (const GuidedTarget& target : targets_) {
    if (target.cluster != cluster) continue;
    const EyeCamera& camera = guide_.camera();
    const EyeCamera::SamplePlace at = camera.place_of(x_, y_, sample, sequence_);
    return share_of_plain(target, camera.slope_x(at.film_x), camera.slope_y(at.film_y), at.px, at.py);
  }
  return 1.0f;
}

Eigen::Vector3f GuidedPixel::sample(std::uint32_t sample, RenderCounters& counters) const {
  const Eigen::Vector3f nothing = Eigen::Vector3f::Zero();
  const GuidedTarget& target = chosen(targets_, unit_float(sequence_.single(sample, dimension::guided_choice)));
  const EyeCamera& camera = guide_.camera();
  const auto film = sequence_.pair(sample, dimension::guided_film),
             lens = sequence_.pair(sample, dimension::guided_lens);
  const float film_x = static_cast<float>(x_) + unit_float(film.x),
              film_y = static_cast<float>(y_) + unit_float(film.y);
  const float qx = camera.slope_x(film_x), qy = camera.slope_y(film_y);
  const EmitterGuide::Proposal p =
      guide_.guide().propose(target.cluster, qx, qy, unit_float(lens.x), unit_float(lens.y));
  if (!(p.pdf > 0.0f)) return nothing;
  const EyeCamera::SingleRay ray = camera.single(film_x, film_y, p.px, p.py);
  if (ray.status == LaunchStatus::dropped) return nothing;
  ++counters.guided_rays;
  const auto emission = emission_met(guide_.scene(), guide_.clusters(), target.cluster, ray.origin, ray.direction);
  if (!emission) return nothing;
  ++counters.guided_hits;
  // f π_plain / (π_plain + P g) per guided density P g, over π_plain, the density that the mean over the pupil stands
  // for.
  return *emission * (plain_pdf_ / (plain_pdf_ + target.probability * p.pdf));
}

}  // namespace sturm
