// Files with one NumPy array (.npy): reads versions 1 to 3, writes version 1.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace lippmann {

struct NpyArray {
  std::vector<std::size_t> shape;
  std::vector<double> values;
};

/// Reads an array of floats ('f4', 'f8') of either byte order, in C or Fortran order. Throws Error naming `where` for any other
/// type, for more than two dimensions, and if the file does not have as many numbers as its header states.
NpyArray parse_npy(std::span<const std::byte> file, const std::string& where);

/// Returns the bytes of a file. type: NumPy's name for the type of the numbers, such as "<f4". bytes: the array in C order.
std::vector<std::byte> npy_file(const std::string& type, const std::vector<std::size_t>& shape,
                                std::span<const std::byte> bytes);

/// Returns the bytes of a file with `values` in C order. The product of `shape` is the number of values.
template <class T>
requires std::is_arithmetic_v<T> std::vector<std::byte> encode_npy(std::span<const T> values,
                                                                   const std::vector<std::size_t>& shape) {
  static_assert(std::endian::native == std::endian::little);
  assert(std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()) == values.size());
  const char kind = std::floating_point<T> ? 'f' : std::is_signed_v<T> ? 'i' : 'u';
  return npy_file(fmt::format("{}{}{}", sizeof(T) == 1 ? '|' : '<', kind, sizeof(T)), shape, std::as_bytes(values));
}

}  // namespace lippmann
