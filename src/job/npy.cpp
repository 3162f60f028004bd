// Based on: NumPy enhancement proposal 1, "A simple file format for NumPy arrays", format 1.0.
#include "job/npy.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace lippmann {

std::vector<std::byte> npy_file(const std::string& dtype, const std::vector<int>& shape, std::span<const std::byte> bytes) {
  constexpr std::size_t kPrefix = 10, kAlignment = 64;
  std::string header =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},), }}", dtype, fmt::join(shape, ", "));
  header.append(kAlignment - (kPrefix + header.size() + 1) % kAlignment, ' ');
  header += '\n';
  std::string start("\x93NUMPY\x01\x00", 8);
  start += static_cast<char>(header.size() & 0xff);
  start += static_cast<char>(header.size() >> 8);
  start += header;
  std::vector<std::byte> file(start.size() + bytes.size());
  std::ranges::copy(std::as_bytes(std::span(start)), file.begin());
  std::ranges::copy(bytes, file.begin() + static_cast<std::ptrdiff_t>(start.size()));
  return file;
}

}  // namespace lippmann
