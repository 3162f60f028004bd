// Unpacks accessors: arrays of numbers in a glTF file's buffers, of any component type, strided, normalised, sparse.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "lippmann/core/math.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Checks what the schema cannot: that buffer views lie within buffers. Throws Error.
void check_views(const Document& document);
/// The same of accessors within buffer views, which have been checked.
void check_accessors(const Document& document);

/// The accessor's elements as floats. Integers become what they stand for where the accessor is normalised, else their value.
/// Throws Error at the accessor if its type is not T's or a number is not finite. T: float, Vec2f, Vec3f, Vec4f, glm::mat4.
template <class T>
std::vector<T> unpack(Document& document, int accessor);

/// Elements of one integer each (vertex indices) or of four (joints), unsigned.
template <class T>
std::vector<T> unpack_unsigned(Document& document, int accessor);

using Joints = glm::vec<4, std::uint32_t>;

}  // namespace lippmann::gltf
