// The header of a PLY file: its elements and their properties.
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
  std::optional<Type> count_type;  ///< type of a list's length, which precedes its values; none: a single value
};

struct Element {
  std::string name;
  std::int64_t count = 0;  ///< 0 to 2^31 - 1
  std::vector<Property> properties;
};

struct Header {
  Format format = Format::kText;
  std::vector<Element> elements;
  std::size_t size = 0;                    ///< bytes up to the body
  std::vector<std::string> texture_files;  ///< from comments "TextureFile NAME", in order
  bool is_z_up = false;                    ///< from a comment "Vertical Axis: z", as nerfstudio writes
  LeftOut foreign_lines;                   ///< first words of lines that are not statements
};

/// Parses a header. Throws Error naming file and line.
Header parse_header(const std::string& name, std::string_view contents);

}  // namespace lippmann::ply
