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

enum class Mode : int { kPoints = 0, kTriangles = 4, kTriangleStrip, kTriangleFan };
Mode mode_of(Value primitive);

std::vector<PrimitiveId> all_primitives(const Document& document);
Value primitive_of(const Document& document, PrimitiveId id);
std::string element(PrimitiveId id);

int attribute(Value primitive, const std::string& name);

/// Returns one value per vertex, or no values if the primitive does not have the attribute. T is Vec2f, Vec3f or Vec4f.
template <class T>
std::vector<T> read_attribute(Document& document, PrimitiveId id, const std::string& name, std::size_t vertices);

/// Returns one value per vertex from an accessor, or no values if `accessor` is -1. `name` names the attribute in messages.
template <class T>
std::vector<T> read_per_vertex(Document& document, PrimitiveId id, int accessor, const std::string& name, std::size_t vertices);

void warn_about_unread_attributes(Document& document, PrimitiveId id);

/// Reads COLOR_0, which is RGB or RGBA. Leaves mesh.colors empty if all colours are white, and mesh.alphas empty if all
/// vertices are opaque.
void read_colors(Document& document, PrimitiveId id, Mesh& mesh);

/// Reads TANGENT into mesh.tangents. Tangents are normalised, and w becomes -1 or 1. If a tangent has zero length, warns and
/// leaves mesh.tangents empty.
void read_tangents(Document& document, PrimitiveId id, Mesh& mesh);

}  // namespace lippmann::gltf
