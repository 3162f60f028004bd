#include "scene/gltf/attribute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scene/gltf/accessor.hpp"

namespace lippmann::gltf {

Mode mode_of(Value primitive) { return static_cast<Mode>(primitive["mode"].integer(static_cast<int>(Mode::kTriangles))); }

std::vector<PrimitiveId> all_primitives(const Document& document) {
  std::vector<PrimitiveId> all;
  const Value meshes = document.root["meshes"];
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; p < meshes.at(m)["primitives"].size(); ++p)
      all.push_back({static_cast<int>(m), static_cast<int>(p)});
  return all;
}

Value primitive_of(const Document& document, PrimitiveId id) {
  return document.at("meshes", id.mesh)["primitives"].at(static_cast<std::size_t>(id.primitive));
}

std::string element(PrimitiveId id) {
  return element("meshes", static_cast<std::size_t>(id.mesh), "primitives", static_cast<std::size_t>(id.primitive));
}

int attribute(Value primitive, const std::string& name) { return primitive["attributes"][name].index(); }

template <class T>
std::vector<T> read_per_vertex(Document& document, PrimitiveId id, int accessor, const std::string& name,
                               std::size_t vertices) {
  if (accessor < 0) return {};
  const std::size_t count = document.accessor(accessor).count;
  if (count != vertices)
    document.report.fail(element(id), fmt::format("has {} positions, but {} values of {}", vertices, count, name));
  return unpack<T>(document, accessor);
}

template <class T>
std::vector<T> read_attribute(Document& document, PrimitiveId id, const std::string& name, std::size_t vertices) {
  return read_per_vertex<T>(document, id, attribute(primitive_of(document, id), name), name, vertices);
}

void warn_about_unread_attributes(Document& document, PrimitiveId id) {
  constexpr std::string_view kRead[] = {"POSITION", "NORMAL", "TANGENT", "COLOR_0"};
  constexpr std::string_view kSets[] = {"TEXCOORD_", "JOINTS_", "WEIGHTS_"};
  for (const auto& [name, accessor] : primitive_of(document, id)["attributes"].index_map()) {
    const auto begins = [&attribute_name = name](std::string_view set) { return attribute_name.starts_with(set); };
    if (std::find(std::begin(kRead), std::end(kRead), name) != std::end(kRead)) continue;
    if (std::any_of(std::begin(kSets), std::end(kSets), begins)) continue;
    document.report.warn_at(fmt::format("the attribute {} is left out", shown(name)), element(id));
  }
}

void read_colors(Document& document, PrimitiveId id, Mesh& mesh) {
  const int accessor = attribute(primitive_of(document, id), "COLOR_0");
  if (accessor < 0) return;
  const std::size_t vertices = mesh.positions.size();
  if (document.accessor(accessor).components == 3) {
    mesh.colors = read_per_vertex<Vec3f>(document, id, accessor, "COLOR_0", vertices);
  } else {
    for (const Vec4f& rgba : read_per_vertex<Vec4f>(document, id, accessor, "COLOR_0", vertices)) {
      mesh.colors.emplace_back(rgba);
      mesh.alphas.push_back(std::clamp(rgba.a, 0.0f, 1.0f));
    }
  }
  for (Vec3f& color : mesh.colors) color = glm::clamp(color, Vec3f(0.0f), Vec3f(1.0f));
  if (std::all_of(mesh.colors.begin(), mesh.colors.end(), [](Vec3f c) { return c == Vec3f(1.0f); })) mesh.colors.clear();
  if (std::all_of(mesh.alphas.begin(), mesh.alphas.end(), [](float a) { return a == 1.0f; })) mesh.alphas.clear();
}

void read_tangents(Document& document, PrimitiveId id, Mesh& mesh) {
  mesh.tangents = read_attribute<Vec4f>(document, id, "TANGENT", mesh.positions.size());
  for (Vec4f& tangent : mesh.tangents) {
    const Vec3f t(tangent);
    const float longest = std::max({std::abs(t.x), std::abs(t.y), std::abs(t.z)});
    if (!(longest > 0.0f)) {
      document.report.warn_at("meshes with zero-length tangents get tangents computed from the texture coordinates",
                              element(id));
      return mesh.tangents.clear();
    }
    tangent = Vec4f(glm::normalize(t / longest), tangent.w < 0.0f ? -1.0f : 1.0f);
  }
}

template std::vector<Vec2f> read_attribute(Document&, PrimitiveId, const std::string&, std::size_t);
template std::vector<Vec3f> read_attribute(Document&, PrimitiveId, const std::string&, std::size_t);
template std::vector<Vec4f> read_attribute(Document&, PrimitiveId, const std::string&, std::size_t);
template std::vector<Vec3f> read_per_vertex(Document&, PrimitiveId, int, const std::string&, std::size_t);

}  // namespace lippmann::gltf
