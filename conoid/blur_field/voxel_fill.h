#pragma once
#include "conoid/blur_field/traced_directions.h"
#include "conoid/blur_field/voxel_field.h"
#include "lensmodel/eye.h"
#include "lensmodel/field_method.h"

namespace sturm {

/// Fills all voxels, or only those of `visible` (null: all). `directions` are those of `grid` through the same lens
/// (null: naked eye). Rows are shared out to threads; the result does not depend on their number.
VoxelField fill_voxels(const Spectacles* lens, const Eye& eye, const FieldGrid& grid,
                       const TracedDirections& directions, FieldMethod method = FieldMethod::ray_transfer,
                       const VoxelMask* visible = nullptr);

}  // namespace sturm
