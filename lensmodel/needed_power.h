#pragma once
#include "lensmodel/eye.h"

namespace sturm {

/// The back vertex power that corrects an eye at another vertex distance than its prescription is written for; its
/// prism stays. As written where the distance is the same.
Prescription needed_power(const Eye& eye, double vertex_distance_m);

}  // namespace sturm
