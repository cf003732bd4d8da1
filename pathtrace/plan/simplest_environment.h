#pragma once
#include <optional>

#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// The surroundings with the same radiance in every direction, bit by bit, that ask for the least: a picture of one
/// value is a colour, which no light sample is spent on, and black is nothing.
std::optional<Environment> simplest_environment(const std::optional<Environment>& environment);

/// The same radiance as a picture of one pixel, which is sampled as a light: what a colour would cost otherwise.
std::optional<Environment> sampled_environment(const std::optional<Environment>& environment);

}  // namespace sturm
