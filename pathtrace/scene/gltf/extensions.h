#pragma once
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm::gltf {

/// Throws InputError where the document requires an extension without which what it shows would be wrong: one that is
/// neither read nor known to be a mere refinement.
void check_required_extensions(const Json& gltf, const Source& root);

/// A sentence for each extension that the document uses and that is left out, or taken only in part.
std::vector<std::string> extension_notes(const Json& gltf, const Source& root);

/// Throws InputError for a buffer without bytes of its own, whose contents are compressed elsewhere.
void refuse_compressed_buffer(const Json& buffer, const Source& where);

/// What a material's extensions would add, in words: "transmission", "clear coat".
std::vector<std::string> extensions_left_out(const Json& material);

}  // namespace sturm::gltf
