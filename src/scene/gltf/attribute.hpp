// Reads the vertex attributes of a primitive of a glTF mesh.
#pragma once

#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

struct PrimitiveId {
  int mesh = 0, primitive = 0;
  auto operator<=>(const PrimitiveId&) const = default;
};

/// As glTF numbers them.
enum class Mode : int { kPoints = 0, kTriangles = 4, kTriangleStrip, kTriangleFan };
Mode mode_of(Value primitive);

std::vector<PrimitiveId> all_primitives(const Document& document);
Value primitive_of(const Document& document, PrimitiveId id);
std::string element(PrimitiveId id);

/// The accessor of an attribute; -1: the primitive does not have it.
int attribute(Value primitive, const std::string& name);

/// One value per vertex, or none where the primitive does not have the attribute. T: Vec2f, Vec3f, Vec4f.
template <class T>
std::vector<T> read_attribute(Document& document, PrimitiveId id, const std::string& name, std::size_t vertices);

/// The same of an accessor (`name` for messages); -1: none.
template <class T>
std::vector<T> read_per_vertex(Document& document, PrimitiveId id, int accessor, const std::string& name, std::size_t vertices);

/// Warns of attributes that no mesh has a use for.
void warn_of_unread_attributes(Document& document, PrimitiveId id);

/// COLOR_0, RGB or RGBA, into mesh.colors and mesh.alphas; what is white or opaque everywhere is left out.
void read_colors(Document& document, PrimitiveId id, Mesh& mesh);

/// TANGENT, made unit length, +-1 in w. None, with a warning, where one has no direction.
void read_tangents(Document& document, PrimitiveId id, Mesh& mesh);

}  // namespace lippmann::gltf
