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
  /// Type of a list's length, which the file stores before the list's values. None: the property is a single value.
  std::optional<Type> count_type;
};

struct Element {
  std::string name;
  std::int64_t count = 0;  ///< number of rows, 0 to 2^31 - 1
  std::vector<Property> properties;
};

struct Header {
  Format format = Format::kText;
  std::vector<Element> elements;
  std::size_t size = 0;                    ///< length of the header in bytes
  std::vector<std::string> texture_files;  ///< from the comments "TextureFile NAME", in file order
  bool is_z_up = false;                    ///< the file contains nerfstudio's comment "Vertical Axis: z"
  LeftOut foreign_lines;                   ///< first words of the lines that are not statements
};

/// Parses the header at the beginning of `contents`. `name` names the file in messages. Throws Error naming file and line.
Header parse_header(const std::string& name, std::string_view contents);

}  // namespace lippmann::ply
