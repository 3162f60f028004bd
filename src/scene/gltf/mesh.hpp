#pragma once

#include <optional>

#include "scene/gltf/attribute.hpp"
#include "scene/gltf/material.hpp"

namespace lippmann::gltf {

/// Returns a primitive as a mesh. Strips and fans are split into triangles. Without NORMAL, the mesh is flat-shaded. For
/// points, lines and primitives without positions, warns and returns none. Throws Error.
std::optional<Mesh> read_mesh(Document& document, PrimitiveId id, const MaterialNeeds& needs);

}  // namespace lippmann::gltf
