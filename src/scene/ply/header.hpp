#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/left_out.hpp"

namespace lippmann::ply {

enum class Format { kText, kLittleEndian, kBigEndian };

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

int bytes_of(Type type);

struct Property {
  std::string name;
  Type type = Type::kFloat;
  /// Type of a list's length, which the file stores before the list's values. None: the property is a single value.
  std::optional<Type> count_type;
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Format format = Format::kText;
  std::vector<Element> elements;
  std::size_t size = 0;
  std::vector<std::string> texture_files;
  bool is_z_up = false;
  LeftOut foreign_lines;
};

Header parse_header(const std::string& name, std::string_view contents);

}  // namespace lippmann::ply
