// lippmann::Error becomes lippmann.Error, with the same parts: where, problem, accepted.
#include "bindings.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::python {
namespace {

/// Text that comes from outside (names of files) need not be UTF-8.
py::object text(const std::string& bytes) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace"));
}

void raise(const Error& error) {
  const py::object type = py::module_::import("lippmann._errors").attr("Error");
  const py::object value = type(text(error.where()), text(error.problem()), text(error.accepted()));
  PyErr_SetObject(type.ptr(), value.ptr());
}

}  // namespace

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
