#pragma once
#include <cstdint>

#include "pathtrace/cameras/ray_model.h"

namespace sturm {

struct RenderCounters {
  RayCounters camera;
  std::uint64_t bounce_rays = 0, shadow_rays = 0;
  std::uint64_t guided_rays = 0,
                guided_hits = 0;  ///< rays sent by an EmitterGuide or ViewGuide, and those that met their emitter

  RenderCounters& operator+=(const RenderCounters& part) {
    camera += part.camera;
    bounce_rays += part.bounce_rays;
    shadow_rays += part.shadow_rays;
    guided_rays += part.guided_rays;
    guided_hits += part.guided_hits;
    return *this;
  }
};

}  // namespace sturm
