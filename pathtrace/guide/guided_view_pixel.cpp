#include "pathtrace/guide/guided_view_pixel.h"

namespace sturm {

GuidedViewPixel::GuidedViewPixel(const ViewGuide& guide, int x, int y, const PixelSequence& sequence)
    : guide_(guide), x_(x), y_(y), sequence_(sequence), focus_bundle_(guide.camera().focus_bundle(x, y)) {
  guide.find_targets(x, y, focus_bundle_, targets_);
}

float GuidedViewPixel::share_of_plain(const GuidedTarget& target, float proposed_pdf,
                                      const Eigen::Vector2f& point) const {
  return 1.0f /
         (1.0f + target.probability * proposed_pdf / guide_.plain_pdf(point));  // the plain density may be infinite
}

float GuidedViewPixel::plain_weight(int emitter, std::uint32_t sample) const {
  const int cluster = guide_.clusters().cluster_of(emitter);
  for (const GuidedTarget& target : targets_) {
    if (target.cluster != cluster) continue;
    const ViewCamera::SamplePlace at = guide_.camera().place_of(x_, y_, sample, sequence_);
    const auto place = guide_.place(at.film_x, at.film_y, focus_bundle_);
    if (!place) return 1.0f;
    const auto region = guide_.region(cluster, *place);
    const double radius = guide_.camera().rays().pupil_radius();
    const Eigen::Vector2f point = (radius * at.pupil.point).cast<float>();
    return region ? share_of_plain(target, region->pdf(point), point) : 1.0f;
  }
  return 1.0f;
}

Eigen::Vector3f GuidedViewPixel::sample(std::uint32_t sample, RenderCounters& counters) const {
  const Eigen::Vector3f nothing = Eigen::Vector3f::Zero();
  const GuidedTarget& target = chosen(targets_, unit_float(sequence_.single(sample, dimension::guided_choice)));
  const auto film = sequence_.pair(sample, dimension::guided_film),
             lens = sequence_.pair(sample, dimension::guided_lens);
  const auto place = guide_.place(x_ + unit_double(film.x), y_ + unit_double(film.y), focus_bundle_);
  if (!place) return nothing;
  const auto region = guide_.region(target.cluster, *place);
  if (!region) return nothing;
  const Eigen::Vector2f point = region->point(unit_float(lens.x), unit_float(lens.y));
  const ViewCamera& camera = guide_.camera();
  const double radius = camera.rays().pupil_radius();
  const Eigen::Vector2d unit = point.cast<double>() / radius;
  if (unit.squaredNorm() > 1.0) return nothing;
  const ViewCamera::SingleRay ray =
      camera.single(place->camera, static_cast<double>(point.x()), static_cast<double>(point.y()));
  ++counters.guided_rays;
  if (!goes_on(ray.status)) return nothing;
  const auto emission = emission_met(guide_.scene(), guide_.clusters(), target.cluster, ray.origin, ray.direction);
  if (!emission) return nothing;
  ++counters.guided_hits;
  // f w π_plain / (π_plain + P g) per guided density P g, over π_plain, the density that the mean over the samples
  // stands for.
  return *emission * (static_cast<float>(camera.pupil().weight(unit)) *
                      share_of_plain(target, 1.0f / region->rectangle.area(), point));
}

}  // namespace sturm
