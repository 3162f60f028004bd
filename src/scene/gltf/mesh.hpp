// Turns one primitive of a glTF mesh into a triangle mesh.
#pragma once

#include <optional>

#include "scene/gltf/document.hpp"
#include "scene/scene.hpp"

namespace lippmann::gltf {

struct PrimitiveId {
  int mesh = 0, primitive = 0;
  auto operator<=>(const PrimitiveId&) const = default;
};

const tinygltf::Primitive& primitive_of(const Document& document, PrimitiveId id);
std::string element(PrimitiveId id);

/// Strips and fans become single triangles; without NORMAL the mesh is faceted. `uv_set`: which TEXCOORD_n the material's
/// textures use. Nothing, with a warning, where there are no triangles (points, lines, no positions). Throws Error.
std::optional<Mesh> read_mesh(Document& document, PrimitiveId id, int uv_set);

}  // namespace lippmann::gltf
