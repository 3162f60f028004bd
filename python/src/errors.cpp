// Translates the C++ exception lippmann::Error to the Python exception lippmann.Error.
#include "bindings.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::python {
namespace {

void raise(const Error& error) {
  const py::object type = py::module_::import("lippmann._errors").attr("Error");
  const py::object value = type(decoded(error.where()), decoded(error.problem()), decoded(error.accepted()));
  PyErr_SetObject(type.ptr(), value.ptr());
}

}  // namespace

py::str decoded(const std::string& bytes) {
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace"));
}

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace lippmann::python
