#pragma once
#include "conoid/blur_field/traced_directions.h"
#include "conoid/blur_field/voxel_field.h"
#include "lensmodel/eye.h"

namespace sturm {

/// How the ellipses of a blur field are computed.
enum class FieldMethod {
  ray_transfer,  ///< exact to first order; every mode of accommodation, `best` voxel by voxel
  published,     ///< [Kakimoto2010] eqs. 9–11; `best` is eq. 12 between the relaxed and the tense eye
  previous       ///< [Kakimoto2010] Table 1; `best` as by ray_transfer
};

/// Fills all voxels, or only those of `visible` (null: all). `directions` are those of `grid` through the same lens
/// (null: naked eye). Rows are shared out to threads; the result does not depend on their number.
VoxelField fill_voxels(const Spectacles* lens, const Eye& eye, const FieldGrid& grid,
                       const TracedDirections& directions, FieldMethod method = FieldMethod::ray_transfer,
                       const VoxelMask* visible = nullptr);

}  // namespace sturm
