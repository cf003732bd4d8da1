#pragma once
#include "io/json/json.h"

namespace sturm {

/// Throws InputError unless the "id" of each element of a list is its own.
void require_unique_ids(const Json& list, const Source& where);

}  // namespace sturm
