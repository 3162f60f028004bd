// Reads vertex attributes of glTF mesh primitives.
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

/// Primitive modes with glTF's numbers.
enum class Mode : int { kPoints = 0, kTriangles = 4, kTriangleStrip, kTriangleFan };
Mode mode_of(Value primitive);

std::vector<PrimitiveId> all_primitives(const Document& document);
Value primitive_of(const Document& document, PrimitiveId id);
std::string element(PrimitiveId id);

/// Returns the accessor of an attribute; -1 if the primitive lacks it.
int attribute(Value primitive, const std::string& name);

/// Returns one value per vertex; empty if the primitive lacks the attribute. T: Vec2f, Vec3f, Vec4f.
template <class T>
std::vector<T> read_attribute(Document& document, PrimitiveId id, const std::string& name, std::size_t vertices);

/// Returns one value per vertex from an accessor; empty if `accessor` is -1. `name` names the attribute in messages.
template <class T>
std::vector<T> read_per_vertex(Document& document, PrimitiveId id, int accessor, const std::string& name, std::size_t vertices);

/// Warns about attributes that the reader ignores.
void warn_about_unread_attributes(Document& document, PrimitiveId id);

/// Reads COLOR_0, RGB or RGBA, into mesh.colors and mesh.alphas. Leaves colors empty if all are white, and alphas if all are
/// opaque.
void read_colors(Document& document, PrimitiveId id, Mesh& mesh);

/// Reads TANGENT into mesh.tangents, normalised, with +-1 in w. Leaves them empty, with a warning, if a tangent has zero
/// length.
void read_tangents(Document& document, PrimitiveId id, Mesh& mesh);

}  // namespace lippmann::gltf
