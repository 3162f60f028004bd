// NumPy files with one array (.npy, versions 1 to 3), of numbers with 4 or 8 bytes, in C or Fortran order.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct NpyArray {
  std::vector<std::size_t> shape;
  std::vector<double> values;  ///< in C order: the last index runs fastest
};

/// Reads floats ('f4', 'f8') of either byte order. Throws Error naming `where` for other types, for more than two dimensions,
/// and if the number of values differs from the header.
NpyArray parse_npy(std::span<const std::byte> file, const std::string& where);

/// Encodes an array as little-endian in C order. The product of `shape` must be the number of values.
std::vector<std::byte> encode_npy(std::span<const double> values, const std::vector<std::size_t>& shape);
std::vector<std::byte> encode_npy(std::span<const float> values, const std::vector<std::size_t>& shape);

}  // namespace lippmann
