#include "pathtrace/guide/guided_pixel.h"

#include "pathtrace/guide/emitter_guide.h"
#include "pathtrace/guide/view_guide.h"

namespace sturm {

template <PupilGuide Guide>
GuidedPixel<Guide>::GuidedPixel(const Guide& guide, int x, int y, const PixelSequence& sequence)
    : guide_(guide), sequence_(sequence), pixel_(guide.camera().pixel(x, y)) {
  guide.find_targets(pixel_, targets_);
}

template <PupilGuide Guide>
float GuidedPixel<Guide>::plain_weight(int emitter, std::uint32_t sample) const {
  const int cluster = guide_.clusters().cluster_of(emitter);
  for (const GuidedTarget& target : targets_) {
    if (target.cluster != cluster) continue;
    const auto at = guide_.camera().place_of(pixel_, sample, sequence_);
    const auto place = guide_.place(pixel_, at.film);
    if (!place) return 1.0f;
    const auto region = guide_.region(cluster, *place);
    if (!region) return 1.0f;
    const Eigen::Vector2f point = guide_.camera().pupil_point(at);
    return guide_.share_of_plain(target.probability * region->pdf(point), point);
  }
  return 1.0f;
}

template <PupilGuide Guide>
Eigen::Vector3f GuidedPixel<Guide>::sample(std::uint32_t sample, RenderCounters& counters) const {
  const Eigen::Vector3f nothing = Eigen::Vector3f::Zero();
  const GuidedTarget& target = chosen(targets_, unit_float(sequence_.single(sample, dimension::guided_choice)));
  const auto film = sequence_.pair(sample, dimension::guided_film),
             lens = sequence_.pair(sample, dimension::guided_lens);
  const auto place = guide_.place(pixel_, guide_.camera().film_place(pixel_, film));
  if (!place) return nothing;
  const auto region = guide_.region(target.cluster, *place);
  if (!region) return nothing;
  const Eigen::Vector2f point = region->point(unit_float(lens.x), unit_float(lens.y));
  const auto ray = guide_.ray(*place, point);
  if (!ray) return nothing;
  ++counters.guided_rays;
  if (!goes_on(ray->status)) return nothing;
  const auto emission = emission_met(guide_.scene(), guide_.clusters(), target.cluster, ray->origin, ray->direction);
  if (!emission) return nothing;
  ++counters.guided_hits;
  // f w π_plain / (π_plain + P g) per guided density P g, over π_plain, the density that the mean over the samples
  // stands for.
  return *emission *
         (guide_.plain_weight(point) * guide_.share_of_plain(target.probability * region->proposed_pdf(), point));
}

template class GuidedPixel<EmitterGuide>;
template class GuidedPixel<ViewGuide>;

}  // namespace sturm
