// Read-only NumPy arrays that share the library's memory, and checked copies of arrays from Python.
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <vector>

#include "bindings.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann::python {

template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// Returns a read-only array of the memory at `data`, which belongs to `owner`. The array keeps `owner` alive.
template <class T, class Owner>
py::array view_of(const T* data, std::vector<py::ssize_t> shape, std::shared_ptr<Owner> owner) {
  auto* kept = new std::shared_ptr<Owner>(std::move(owner));
  const py::capsule base(kept, [](void* pointer) { delete static_cast<std::shared_ptr<Owner>*>(pointer); });
  py::array_t<T> array(std::move(shape), data, base);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Returns an array that takes over the memory of `data` without a copy.
template <class T>
py::array moved(std::vector<T> data, std::vector<py::ssize_t> shape) {
  auto* kept = new std::vector<T>(std::move(data));
  const py::capsule base(kept, [](void* pointer) { delete static_cast<std::vector<T>*>(pointer); });
  return py::array_t<T>(std::move(shape), kept->data(), base);
}

/// Returns an array of shape (y, x, channel) that takes over the memory of the image without a copy.
inline py::array moved(Image image) {
  const std::vector<py::ssize_t> shape{image.height, image.width, image.channels};
  return moved(std::move(image.data), shape);
}

/// Throws Error naming `name` unless the array has the given shape. A -1 in the shape allows any length.
void require_shape(const py::array& array, std::initializer_list<py::ssize_t> shape, const char* name);

/// Returns the rows of an array (n, 2), (n, 3) or (n, 4). Throws Error naming `name`.
template <class Vec>
std::vector<Vec> vectors_of(const Array<float>& array, const char* name) {
  require_shape(array, {-1, Vec::length()}, name);
  std::vector<Vec> vectors(static_cast<std::size_t>(array.shape(0)));
  const float* data = array.data();
  for (Vec& vector : vectors)
    for (int c = 0; c < Vec::length(); ++c) vector[c] = *data++;
  return vectors;
}

/// Copies an array of shape (y, x, channels) to an image. Throws Error naming `name`.
Image image_of(const Array<float>& array, int channels, const char* name);

/// Returns the (4, 4) matrix, for column vectors, of `transform` followed by a translation by `origin`.
py::array matrix_of(const Affine3f& transform, const Vec3d& origin);

}  // namespace lippmann::python
