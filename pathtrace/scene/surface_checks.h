#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <string>

#include "pathtrace/scene/scene_description.h"

namespace sturm {

// What a scene can be built from. All throw InputError that names the surface.

/// A position [m] that single precision resolves to a millimetre; `where` is for the message.
void require_usable(const Eigen::Vector3f& position, const std::string& where);

/// Material and corners that exist, one of everything for each position, normals of unit length.
void require_usable(const Mesh& mesh, std::size_t material_count);

/// A material that exists and a radius above 0.
void require_usable(const Sphere& sphere, std::size_t material_count);

}  // namespace sturm
