// Based on: NumPy Enhancement Proposal 1, "A simple file format for NumPy arrays".
#include "core/npy.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/printable.hpp"
#include "core/text_pattern.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::string_view kNpyMagic = "\x93NUMPY";
constexpr const char* kNpyAccepted = "a .npy file with a table of floats ('<f4' or '<f8')";

struct NpyHeader {
  bool is_big_endian = false, is_fortran = false;
  std::size_t item = 8;
  std::vector<std::size_t> shape;
  std::size_t data = 0;
};

std::size_t little_endian(std::span<const std::byte> bytes) {
  std::size_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | std::to_integer<std::size_t>(bytes[i]);
  return value;
}

std::optional<std::string> npy_value(const std::string& text, const TextPattern& member) {
  const auto found = member.search(text);
  return found ? std::optional(found->groups[1]) : std::nullopt;
}

NpyHeader npy_header(std::span<const std::byte> file, const std::string& where) {
  constexpr std::size_t kLongest = 4096;
  const std::string_view begin(reinterpret_cast<const char*>(file.data()), std::min<std::size_t>(file.size(), 8));
  if (!begin.starts_with(kNpyMagic) || file.size() < 12) throw Error(where, "is not a .npy file", kNpyAccepted);
  const std::size_t size_bytes = begin[6] == 1 ? 2 : 4;
  const std::size_t length = little_endian(file.subspan(8, size_bytes));
  NpyHeader header;
  header.data = 8 + size_bytes + length;
  if (length > kLongest || header.data > file.size()) throw Error(where, "ends within its header", kNpyAccepted);
  const std::string text(reinterpret_cast<const char*>(file.data()) + 8 + size_bytes, length);
  static const TextPattern type_of("'descr': {0,4}'([<>][a-z][0-9])'"), order_of("'fortran_order': {0,4}(True|False)"),
      shape_of("'shape': {0,4}\\(([0-9, ]{0,60})\\)");
  const auto type = npy_value(text, type_of), order = npy_value(text, order_of), shape = npy_value(text, shape_of);
  if (!type || !order || !shape) throw Error(where, "its header is " + shown(text), kNpyAccepted);
  if (type->substr(1) != "f4" && type->substr(1) != "f8") throw Error(where, "its numbers are of type " + *type, kNpyAccepted);
  header.is_big_endian = type->front() == '>';
  header.item = type->back() == '4' ? 4 : 8;
  header.is_fortran = *order == "True";
  std::size_t side = 0;
  bool in_number = false;
  for (const char c : *shape + ",") {
    if (c >= '0' && c <= '9')
      side = std::min<std::size_t>(side * 10 + static_cast<std::size_t>(c - '0'), std::size_t{1} << 40), in_number = true;
    else if (in_number)
      header.shape.push_back(std::exchange(side, 0)), in_number = false;
  }
  if (header.shape.size() > 2) throw Error(where, fmt::format("has {} dimensions", header.shape.size()), "1 or 2");
  return header;
}

double npy_number(std::span<const std::byte> bytes, bool is_big_endian) {
  std::byte item[8];
  std::copy(bytes.begin(), bytes.end(), item);
  if (is_big_endian) std::reverse(item, item + bytes.size());
  const std::size_t bits = little_endian(std::span(item, bytes.size()));
  return bytes.size() == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                           : std::bit_cast<double>(std::uint64_t{bits});
}

}  // namespace

NpyArray parse_npy(std::span<const std::byte> file, const std::string& where) {
  const NpyHeader header = npy_header(file, where);
  std::size_t count = 1;
  for (const std::size_t side : header.shape) {
    if (side != 0 && count > file.size() / side) throw Error(where, "has fewer numbers than its header states", kNpyAccepted);
    count *= side;
  }
  if (file.size() - header.data != count * header.item)
    throw Error(
        where, fmt::format("has {} bytes of numbers, but its header states {}", file.size() - header.data, count * header.item),
        kNpyAccepted);
  NpyArray array{header.shape, std::vector<double>(count)};
  const std::size_t rows = header.shape.empty() ? 1 : header.shape[0], columns = rows == 0 ? 0 : count / rows;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = header.is_fortran ? i % columns * rows + i / columns : i;
    array.values[i] = npy_number(file.subspan(header.data + at * header.item, header.item), header.is_big_endian);
  }
  return array;
}

std::vector<std::byte> npy_file(const std::string& type, const std::vector<std::size_t>& shape,
                                std::span<const std::byte> bytes) {
  constexpr std::size_t kAlignment = 64, kBeforeText = kNpyMagic.size() + 4;
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},), }}", type, fmt::join(shape, ", "));
  text.append(kAlignment - (kBeforeText + text.size() + 1) % kAlignment, ' ');
  text += '\n';
  std::string header(kNpyMagic);
  header += '\x01', header += '\0';
  header += static_cast<char>(text.size() & 255), header += static_cast<char>(text.size() >> 8);
  header += text;
  std::vector<std::byte> file(header.size() + bytes.size());
  std::ranges::copy(std::as_bytes(std::span(header)), file.begin());
  std::ranges::copy(bytes, file.begin() + static_cast<std::ptrdiff_t>(header.size()));
  return file;
}

}  // namespace lippmann
