#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "lippmann/core/math.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

void check_views(const Document& document);
void check_accessors(const Document& document);

/// Returns the elements of an accessor as T: float, Vec2f, Vec3f, Vec4f or glm::mat4. Normalised integers become fractions.
/// Throws Error at the accessor if its elements are not of type T, or if a number is not finite.
template <class T>
std::vector<T> unpack(Document& document, int accessor);

/// Returns the elements of an accessor as T: std::uint32_t for vertex indices, or Joints.
template <class T>
std::vector<T> unpack_unsigned(Document& document, int accessor);

using Joints = glm::vec<4, std::uint32_t>;

}  // namespace lippmann::gltf
