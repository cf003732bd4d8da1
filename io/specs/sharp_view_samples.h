#pragma once
#include <cstdint>

namespace sturm {

/// Paths per pixel of a prediction's sharp view unless a document says otherwise. More hardly lower the error of a
/// prediction, whose light is spread over the blur and whose noise is filtered
/// (docs/commands/render.md#what-a-prediction-buys has the measurements).
inline constexpr std::uint64_t samples_of_sharp_view = 16;

}  // namespace sturm
