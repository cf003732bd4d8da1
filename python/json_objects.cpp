#include "python/json_objects.h"

#include <pybind11/stl.h>

#include <cmath>

#include "io/files/error.h"

namespace sturm {

namespace py = pybind11;

namespace {

std::string text_of(const py::handle& object) {
  return py::str(object).cast<std::string>();
}

[[noreturn]] void refuse(const py::handle& object, const Source& where, const char* expected) {
  throw InputError(where.file, where.pointer, py::repr(object).cast<std::string>(), expected);
}

Json whole_number(const py::handle& object) {
  int overflow = 0;
  const long long number = PyLong_AsLongLongAndOverflow(object.ptr(), &overflow);
  if (overflow == 0) return number;
  return PyLong_AsDouble(object.ptr());
}

Json real_number(const py::handle& object, const Source& where) {
  const double number = PyFloat_AsDouble(object.ptr());
  if (std::isnan(number)) refuse(object, where, "a number, not NaN");
  if (std::isinf(number)) return number > 0.0 ? "inf" : "-inf";
  return number;
}

Json object_members(const py::dict& dictionary, const Source& where) {
  Json object = Json::object();
  for (const auto& [key, value] : dictionary) {
    const std::string name = text_of(key);
    object[name] = json_from(value, where / name);
  }
  return object;
}

Json array_members(const py::handle& sequence, const Source& where) {
  Json array = Json::array();
  for (const py::handle member : sequence) array.push_back(json_from(member, where / array.size()));
  return array;
}

}  // namespace

Json json_from(const py::handle& object, const Source& where) {
  if (object.is_none()) return nullptr;
  if (py::isinstance<py::bool_>(object)) return object.cast<bool>();
  if (PyLong_Check(object.ptr())) return whole_number(object);
  if (PyFloat_Check(object.ptr())) return real_number(object, where);
  if (py::isinstance<py::str>(object)) return object.cast<std::string>();
  if (py::isinstance<py::dict>(object)) return object_members(py::reinterpret_borrow<py::dict>(object), where);
  if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) return array_members(object, where);
  if (py::hasattr(object, "tolist")) return json_from(object.attr("tolist")(), where);  // NumPy's arrays and scalars
  if (py::hasattr(object, "__fspath__")) return text_of(object.attr("__fspath__")());
  refuse(object, where, "what JSON can hold: a dictionary, list, text, path, number, boolean or None");
}

py::object object_from(const Json& json) {
  switch (json.type()) {
    case Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case Json::value_t::number_integer:
      return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_unsigned:
      return py::int_(json.get<std::uint64_t>());
    case Json::value_t::number_float:
      return py::float_(json.get<double>());
    case Json::value_t::string:
      return py::str(json.get_ref<const std::string&>());
    case Json::value_t::array: {
      py::list list;
      for (const Json& member : json) list.append(object_from(member));
      return list;
    }
    case Json::value_t::object: {
      py::dict dictionary;
      for (const auto& [key, value] : json.items()) dictionary[py::str(key)] = object_from(value);
      return dictionary;
    }
    default:
      return py::none();
  }
}

GivenDocument given_document(const py::handle& document, const std::string& file) {
  const std::string name = file.empty() ? python_document : file;
  if (py::isinstance<py::dict>(document)) return {json_from(document, {name, ""}), name};
  const Json path = json_from(document, {name, ""});
  if (!path.is_string()) refuse(document, {name, ""}, "a dictionary, or the path of a file");
  return {load_json(path.get<std::string>()), path.get<std::string>()};
}

}  // namespace sturm
