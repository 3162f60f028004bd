#include "scene/ply/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/printable.hpp"

namespace lippmann::ply {
namespace {

constexpr double kLargestNumber = 1e18;  // squares and products of two such numbers are finite floats

template <class T>
double as(const unsigned char* raw) {
  T result;
  std::memcpy(&result, raw, sizeof result);
  return static_cast<double>(result);
}

double decoded(const unsigned char* raw, Type type) {
  switch (type) {
    case Type::kInt8:
      return as<std::int8_t>(raw);
    case Type::kUint8:
      return as<std::uint8_t>(raw);
    case Type::kInt16:
      return as<std::int16_t>(raw);
    case Type::kUint16:
      return as<std::uint16_t>(raw);
    case Type::kInt32:
      return as<std::int32_t>(raw);
    case Type::kUint32:
      return as<std::uint32_t>(raw);
    case Type::kFloat:
      return as<float>(raw);
    case Type::kDouble:
      return as<double>(raw);
  }
  return 0.0;
}

}  // namespace

double Body::value(Type type) {
  if (format_ == Format::kText) return text_value();
  const auto size = static_cast<std::size_t>(bytes_of(type));
  if (bytes_.size() < size) throw error("the file ends here");
  unsigned char raw[8];
  std::memcpy(raw, bytes_.data(), size);
  bytes_.remove_prefix(size);
  if ((format_ == Format::kLittleEndian) != (std::endian::native == std::endian::little)) std::reverse(raw, raw + size);
  return decoded(raw, type);
}

double Body::bounded(Type type) {
  const double result = value(type);
  if (!is_usable(result)) throw error(fmt::format("has the value {}", result), "at most 1e18");
  return result;
}

std::uint32_t Body::checked_index(double value, double highest, std::string_view what) const {
  if (!(0.0 <= value && value <= highest && value == std::floor(value)))
    throw error(fmt::format("{} is {}", what, value), fmt::format("0 to {}", highest));
  return static_cast<std::uint32_t>(value);
}

void Body::floats(std::span<float> row) {
  if (bytes_.size() < row.size_bytes()) throw error("the file ends here");
  std::memcpy(row.data(), bytes_.data(), row.size_bytes());
  bytes_.remove_prefix(row.size_bytes());
}

std::uint32_t Body::length(const Property& list, double most) { return index(*list.count_type, most, "the length of a list"); }

void Body::skip(const Property& property) {
  const std::uint32_t count = property.count_type ? length(property) : 1;
  for (std::uint32_t i = 0; i < count; ++i) value(property.type);
}

void Body::skip(const Element& element) {
  if (element.properties.empty()) return;
  for (std::int64_t row = 0; row < element.count; ++row) {
    set_place(element.name, row);
    for (const Property& property : element.properties) skip(property);
  }
}

Error Body::error(std::string problem, std::string accepted) const {
  return {fmt::format("{}: {} {}", name_, printable(*element_), row_), std::move(problem), std::move(accepted)};
}

double Body::text_value() {
  const std::size_t begin = std::min(bytes_.find_first_not_of(" \t\r\n"), bytes_.size());
  const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", begin), bytes_.size());
  const std::string_view word = bytes_.substr(begin, end - begin);
  bytes_.remove_prefix(end);
  if (word.empty()) throw error("the file ends here");
  double result = 0.0;
  const auto [rest, failure] = std::from_chars(word.data(), word.data() + word.size(), result);
  const bool tiny = failure == std::errc::result_out_of_range && word.find("e-") != word.npos;
  if (rest != word.data() + word.size() || (failure != std::errc{} && !tiny))
    throw error(fmt::format("{} is not a number", shown(word)));
  return tiny ? 0.0 : result;
}

bool is_usable(double value) { return std::abs(value) <= kLargestNumber; }

double full_scale(Type type) {
  constexpr double kFull[] = {127.0, 255.0, 32767.0, 65535.0, 2147483647.0, 4294967295.0, 1.0, 1.0};
  return kFull[static_cast<int>(type)];
}

}  // namespace lippmann::ply
