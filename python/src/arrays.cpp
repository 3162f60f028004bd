#include "arrays.hpp"

#include <algorithm>
#include <string>

#include "lippmann/core/error.hpp"

namespace lippmann::python {
namespace {

std::string number_or_any(py::ssize_t length) { return length < 0 ? "n" : std::to_string(length); }

template <class Lengths>
std::string shape_text(const Lengths& lengths) {
  std::string text;
  for (const py::ssize_t length : lengths) text += (text.empty() ? "" : ", ") + number_or_any(length);
  return "(" + text + ")";
}

}  // namespace

void require_shape(const py::array& array, std::initializer_list<py::ssize_t> shape, const char* name) {
  const std::vector<py::ssize_t> is(array.shape(), array.shape() + array.ndim());
  const bool fits = std::equal(is.begin(), is.end(), shape.begin(), shape.end(),
                               [](py::ssize_t one, py::ssize_t wanted) { return wanted < 0 || one == wanted; });
  if (!fits) throw Error(name, "has the shape " + shape_text(is), "the shape " + shape_text(shape));
}

Image image_of(const Array<float>& array, int channels, const char* name) {
  require_shape(array, {-1, -1, channels}, name);
  Image image(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)), channels);
  std::copy_n(array.data(), image.data.size(), image.data.begin());
  return image;
}

py::array matrix_of(const Affine3f& transform, const Vec3d& origin) {
  std::vector<double> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix.push_back(transform.linear[column][row]);
    matrix.push_back(origin[row] + static_cast<double>(transform.translation[row]));
  }
  for (const double last : {0.0, 0.0, 0.0, 1.0}) matrix.push_back(last);
  return moved(std::move(matrix), {4, 4});
}

}  // namespace lippmann::python
