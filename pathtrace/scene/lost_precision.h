#pragma once
#include <string>

#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// What to say of a mesh whose shape suffered when its positions became single precision at coordinates of up to
/// `largest` [m]; "" where that cannot be seen. It can where neighbouring numbers there are further apart than 1/10000
/// of the mesh's extent or 1/100 of its mean edge.
std::string lost_precision(const Mesh& mesh, double largest);

/// The largest coordinate of a mesh, without its sign.
double largest_coordinate_of(const Mesh& mesh);

}  // namespace sturm
