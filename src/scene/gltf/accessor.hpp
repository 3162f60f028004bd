// Unpacks glTF accessors: typed arrays in buffers, with any component type, strided, normalised or sparse.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "lippmann/core/math.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Checks that all buffer views lie within their buffers, which the schema cannot check. Throws Error.
void check_views(const Document& document);
/// Checks that all accessors lie within their buffer views. Call after check_views(). Throws Error.
void check_accessors(const Document& document);

/// Returns the accessor's elements as floats; normalised integers become fractions. T: float, Vec2f, Vec3f, Vec4f, glm::mat4.
/// Throws Error at the accessor if its type is not T's or a number is not finite.
template <class T>
std::vector<T> unpack(Document& document, int accessor);

/// Returns the accessor's elements as unsigned integers: one per element (vertex indices) or four (joints).
template <class T>
std::vector<T> unpack_unsigned(Document& document, int accessor);

using Joints = glm::vec<4, std::uint32_t>;

}  // namespace lippmann::gltf
