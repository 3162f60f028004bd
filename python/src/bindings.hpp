// Shared declarations of the Python module lippmann._core. Each file binds one part of the library's public headers.
//
// The module takes plain values and returns objects and arrays. python/lippmann/*.py adds argument names and checks.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <string>

namespace lippmann::python {

namespace py = pybind11;

/// Decodes text from files. Invalid UTF-8 becomes the replacement character.
py::str decoded(const std::string& bytes);

void bind_errors(py::module_& module);
void bind_scene(py::module_& module);
void bind_deformation(py::module_& module);
void bind_optics(py::module_& module);
void bind_light_field(py::module_& module);
void bind_renderer(py::module_& module);
void bind_dataset(py::module_& module);

}  // namespace lippmann::python
