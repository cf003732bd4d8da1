#pragma once
#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/json/json.h"

namespace sturm {

/// Name of a document that has no file, in errors.
inline constexpr const char* python_document = "<python>";

/// Dictionaries, lists, tuples, NumPy's arrays and scalars, texts, paths, numbers and None as JSON. An infinite number
/// is "inf", as distances are written. Throws InputError about the place for anything else, and for NaN.
Json json_from(const pybind11::handle& object, const Source& where);

/// The same way back; JSON's null is None.
pybind11::object object_from(const Json& json);

/// A document that a caller gave: a dictionary, or the path of a file.
struct GivenDocument {
  Json document;
  std::string file;  ///< where relative paths start, and the name in errors
};

/// `file` is what a dictionary counts as written in; "" is the working directory.
GivenDocument given_document(const pybind11::handle& document, const std::string& file);

}  // namespace sturm
