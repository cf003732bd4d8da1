#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm::gltf {

/// The list of that name; empty where there is none. Throws InputError where it is no list.
const Json& list(const Json& object, const char* key, const Source& where);

/// The object of that name; empty where there is none. Throws InputError where it is no object.
const Json& object(const Json& parent, const char* key, const Source& where);

/// The object of that name among the extensions of `parent`; null where there is none.
const Json* extension(const Json& parent, const char* name);

/// A member that is a whole number ≥ 0 (also one written as 3.0), or `otherwise`. Throws InputError, also where it is
/// missing and there is no `otherwise`.
std::uint64_t number(const Json& object, const char* key, const Source& where,
                     std::optional<std::uint64_t> otherwise = std::nullopt);

/// A member that names one of `count` things (`what`, e.g. "material"), if it is there.
std::optional<std::size_t> index(const Json& object, const char* key, const Source& where, std::size_t count,
                                 const char* what);

/// A member that is a finite number.
double real(const Json& object, const char* key, const Source& where, double otherwise);

/// A member that is a list of finite numbers, of the size of `otherwise`.
std::vector<double> reals(const Json& object, const char* key, const Source& where,
                          const std::vector<double>& otherwise);

bool flag(const Json& object, const char* key, const Source& where, bool otherwise);
std::string text(const Json& object, const char* key, const Source& where, const std::string& otherwise);

}  // namespace sturm::gltf
