#pragma once
#include "lensmodel/words.h"

namespace sturm {

/// How the ellipses of a blur field are computed.
enum class FieldMethod {
  ray_transfer,  ///< exact to first order; every mode of accommodation, `best` voxel by voxel
  published,     ///< [Kakimoto2010] eqs. 9–11; `best` is eq. 12 between the relaxed and the tense eye
  previous       ///< [Kakimoto2010] Table 1; `best` as by ray_transfer
};

inline constexpr Words<FieldMethod, 3> field_method_words{{{FieldMethod::ray_transfer, "ray_transfer"},
                                                           {FieldMethod::published, "published"},
                                                           {FieldMethod::previous, "previous"}}};  ///< in documents

}  // namespace sturm
