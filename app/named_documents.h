#pragma once
#include <string>
#include <vector>

namespace sturm {

/// Throws InputError, with what was probably meant, for a name on the command line that is neither a file nor "-": a
/// number or a prescription that lost its option or its quotes, a name mistyped, a name of another kind. `kinds` are
/// the folders of shipped documents that may be named; "" in it counts for nothing. `what` is "a lens" or the like.
/// What remains is left to the reader.
void require_document(const std::string& name, const std::vector<std::string>& kinds, const std::string& what);

}  // namespace sturm
