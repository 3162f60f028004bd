// Turns one primitive of a glTF mesh into a triangle mesh.
#pragma once

#include <optional>

#include "scene/gltf/attribute.hpp"
#include "scene/gltf/material.hpp"

namespace lippmann::gltf {

/// Strips and fans become single triangles; without NORMAL the mesh is faceted. Nothing, with a warning, where there are no
/// triangles (points, lines, no positions). Throws Error.
std::optional<Mesh> read_mesh(Document& document, PrimitiveId id, const MaterialNeeds& needs);

}  // namespace lippmann::gltf
