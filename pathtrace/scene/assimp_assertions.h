#pragma once

namespace sturm {

/// Whoever calls this links the function by which a failed assertion within Assimp becomes an exception.
void let_assimp_assert_by_exception();

}  // namespace sturm
