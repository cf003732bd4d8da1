#include <nlohmann/json.hpp>

#include "io/json/schema.h"
#include "python/bindings.h"
#include "python/json_objects.h"

namespace sturm {

namespace {

void check(const py::object& document, const std::string& file) {
  const GivenDocument given = given_document(document, file);
  validate(given.document, format_of(given.document, given.file), given.file);
}

py::object loaded(const py::object& document) {
  return object_from(given_document(document, "").document);
}

}  // namespace

void bind_documents(py::module_& module) {
  using namespace pybind11::literals;
  module.def("validate", &check, "document"_a, "file"_a = "",
             "Checks a document against the schema of its format; what is wrong is an InputError.");
  module.def("load", &loaded, "document"_a, "A JSON document, strictly read, as a dictionary.");
  module.def(
      "schema", [](const std::string& name) { return object_from(schema_document(name)); }, "name"_a,
      "The JSON Schema of a format, e.g. \"render\".");
}

}  // namespace sturm
