#include <pybind11/pybind11.h>

#include "io/files/error.h"
#include "io/files/readable_text.h"
#include "io/specs/notation_tokens.h"
#include "python/bindings.h"

namespace sturm {

namespace {

/// Sets an exception of the Python class `name` (sturm/_errors.py).
template <class... Arguments>
void raise(const char* name, Arguments&&... arguments) {
  const py::object type = py::module_::import("sturm._errors").attr(name);
  const py::object exception = type(std::forward<Arguments>(arguments)...);
  PyErr_SetObject(type.ptr(), exception.ptr());
}

void translate(std::exception_ptr pending) {
  try {
    if (pending) std::rethrow_exception(pending);
  } catch (const InputError& error) {  // names of files need not be text
    raise("InputError", readable_lines(error.what()), readable(error.file()), readable(error.pointer()),
          readable_lines(error.value()), readable_lines(error.expected()));
  } catch (const NotationError& error) {
    raise("InputError", readable_lines(error.what()), "", "", "", readable_lines(error.what()));
  } catch (const RuntimeFailure& error) {
    raise("RuntimeFailure", readable_lines(error.what()));
  }
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator(&translate);
}

}  // namespace sturm
