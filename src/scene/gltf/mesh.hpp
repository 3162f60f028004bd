// Reads a primitive of a glTF mesh as a triangle mesh.
#pragma once

#include <optional>

#include "scene/gltf/attribute.hpp"
#include "scene/gltf/material.hpp"

namespace lippmann::gltf {

/// Returns the mesh, with strips and fans split into triangles; without NORMAL it is faceted. Returns none, with a warning, for
/// points, lines and primitives without positions. Throws Error.
std::optional<Mesh> read_mesh(Document& document, PrimitiveId id, const MaterialNeeds& needs);

}  // namespace lippmann::gltf
