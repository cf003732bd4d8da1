#pragma once
#include <string>

#include "io/json/json.h"

namespace sturm {

/// Gives the eye of a document, or the lens that it is, the prescription of `--rx` in optical notation. An eye in a
/// file of its own is taken from there. Throws InputError for a document without either, and for a text that cannot be
/// read.
void apply_prescription(Json& document, const std::string& text, const std::string& file);

}  // namespace sturm
