#include "scene/ply/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/printable.hpp"
#include "scene/directions.hpp"
#include "scene/ply/columns.hpp"
#include "scene/ply/faces.hpp"
#include "scene/ply/row.hpp"
#include "scene/wind_by_normals.hpp"

namespace lippmann::ply {
namespace {

constexpr const char* kCompressedSplats = "has compressed splats (a .compressed.ply of PlayCanvas or SuperSplat)";
constexpr const char* kCompressedAdvice =
    "an uncompressed .ply, which splat-transform IN OUT.ply writes (npm's @playcanvas/splat-transform)";

/// A vertex attribute and its columns. The attribute is left out for all vertices if one value is unusable.
struct VertexAttribute {
  VertexAttribute() = default;
  template <std::size_t N>
  explicit VertexAttribute(const std::optional<std::array<int, N>>& found) {
    if (found) columns.assign(found->begin(), found->end());
  }

  bool check(const Row& row) {
    for (const int column : columns)
      if (unusable < 0 && !is_usable(row.exact(column))) unusable = column;
    return !columns.empty() && unusable < 0;
  }

  std::vector<int> columns;
  int unusable = -1;
};

void read_vertices(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply) {
  Mesh& mesh = ply.mesh;
  if (!mesh.positions.empty()) throw Error(name, "has two lists of vertices", "one element \"vertex\"");
  Columns columns(element);
  const auto xyz = columns.values<3>({{"x", "y", "z"}});
  if (columns.value("packed_position") >= 0) throw Error(name, kCompressedSplats, kCompressedAdvice);
  if (!xyz) throw Error(name, "its vertices have no position", "properties x, y and z");
  const auto normal = columns.values<3>({{"nx", "ny", "nz"}});
  const auto uv = columns.values<2>({{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}});
  const auto rgb = columns.color();
  const int alpha = columns.alpha(), picture = columns.value("texnumber");
  columns.warn_about_unread(name, context);
  VertexAttribute normals(normal), uvs(uv), colors(rgb), alphas;
  if (alpha >= 0) alphas.columns = {alpha};
  Row row(element);
  const auto vector = [&](const std::array<int, 3>& c) { return Vec3f(row.at(c[0]), row.at(c[1]), row.at(c[2])); };
  for (std::int64_t i = 0; i < element.count; ++i) {
    body.set_place(element.name, i);
    row.read(body);
    const Vec3d at(row.position((*xyz)[0], body), row.position((*xyz)[1], body), row.position((*xyz)[2], body));
    mesh.positions.push_back(Vec3f(at - ply.origin));
    if (normals.check(row)) mesh.normals.push_back(vector(*normal));
    if (uvs.check(row)) mesh.uvs.emplace_back(row.at((*uv)[0]), 1.0f - row.at((*uv)[1]));
    if (colors.check(row)) mesh.colors.push_back(row.color(*rgb));
    if (alphas.check(row)) mesh.alphas.push_back(static_cast<float>(row.share(alpha)));
    if (picture >= 0) ply.vertex_picture.push_back(row.picture(picture));
  }
  row.warn_about_clamped_colors(name, context);
  const auto drop_unusable = [&](const VertexAttribute& attribute, std::string_view plural, auto& values) {
    if (attribute.unusable < 0) return;
    values.clear();
    context.warning(fmt::format("{}: the {} of vertices are left out: property {} has values that are not finite.", name,
                                plural, shown(element.properties[static_cast<std::size_t>(attribute.unusable)].name)));
  };
  drop_unusable(normals, "normals", mesh.normals);
  drop_unusable(uvs, "texture coordinates", mesh.uvs);
  drop_unusable(colors, "colours", mesh.colors);
  drop_unusable(alphas, "alphas", mesh.alphas);
}

void skip(const std::string& name, const Element& element, Body& body, const Context& context) {
  LeftOut left_out;
  left_out.add(element.name, name);
  if (element.count > 0) left_out.warn(context, "element", "elements");
  body.skip(element);
}

void tidy_normals(Mesh& mesh) {
  const auto is_zero = [](Vec3f n) { return n == Vec3f(0.0f); };
  if (std::any_of(mesh.normals.begin(), mesh.normals.end(), is_zero)) mesh.normals.clear();
  for (Vec3f& normal : mesh.normals) normal = direction_of(normal);
}

Error no_triangles(const std::string& name, bool has_vertices, bool has_faces) {
  if (has_vertices && has_faces)
    return Error(name, "all of its faces have zero area", "faces of at least three corners that do not lie on one line");
  const char* problem = has_vertices ? "has vertices and no faces"
                        : has_faces  ? "has faces and no vertices"
                                     : "has neither vertices nor faces";
  return Error(name, problem, "a mesh, points, or splats (vertices with scale_0, rot_0, opacity)");
}

PlyMesh read_elements(const std::string& name, const Header& header, Body& body, const Vec3d& origin, const Context& context) {
  PlyMesh ply;
  ply.origin = origin;
  std::vector<std::pair<const Element*, Body>> before_vertices;
  std::int64_t faces = 0;
  const auto read_triangles = [&](const Element& element, Body& rows) {
    (element.name == "face" ? read_faces : read_strips)(name, element, rows, context, ply);
  };
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    const bool has_triangles = element.name == "face" || element.name == "tristrips";
    if (has_triangles) faces += element.count;
    if (element.name == "vertex")
      read_vertices(name, element, body, context, ply);
    else if (has_triangles && ply.mesh.positions.empty())
      before_vertices.emplace_back(&element, body), body.skip(element);
    else if (has_triangles)
      read_triangles(element, body);
    else
      skip(name, element, body, context);
  }
  if (!ply.mesh.positions.empty())
    for (auto& [element, rows] : before_vertices) read_triangles(*element, rows);
  if (ply.mesh.triangles.empty()) throw no_triangles(name, !ply.mesh.positions.empty(), faces > 0);
  tidy_normals(ply.mesh);
  if (!ply.appearances.empty()) ply.appearances.resize(ply.mesh.triangles.size());
  return ply;
}

void assign_vertex_textures(PlyMesh& ply, const Header& header) {
  const bool uses_vertices = !ply.vertex_picture.empty() && header.texture_files.size() > 1 && ply.appearances.empty();
  if (!uses_vertices) return;
  for (const auto& triangle : ply.mesh.triangles) ply.appearances.push_back({.picture = ply.vertex_picture[triangle[0]]});
}

std::map<int, Mesh> parts_of(PlyMesh& ply, const Header& header) {
  assign_vertex_textures(ply, header);
  if (!ply.appearances.empty()) return split_faces(ply.mesh, ply.appearances, ply.own);
  std::map<int, Mesh> parts;
  parts.emplace(0, std::move(ply.mesh));
  return parts;
}

MetallicRoughness surface_of(const Mesh& mesh, int texture) {
  MetallicRoughness surface;
  surface.base_color = Vec4f(Vec3f(mesh.colors.empty() && texture < 0 ? 0.8f : 1.0f), 1.0f);
  surface.base_color_map.texture = texture;
  surface.metallic = 0.0f;
  surface.double_sided = true;
  surface.blend = std::any_of(mesh.alphas.begin(), mesh.alphas.end(), [](float alpha) { return alpha < 1.0f; });
  return surface;
}

void add_instance(Mesh mesh, int texture, Scene& scene) {
  Instance instance;
  instance.name = "mesh";
  instance.shape = instance.material = static_cast<int>(scene.shapes.size());
  scene.materials.push_back({"surface", surface_of(mesh, texture)});
  scene.shapes.emplace_back(std::move(mesh));
  scene.instances.push_back(std::move(instance));
}

/// Returns the scene's texture index for each texture number of the file. -1: the texture cannot be used.
std::vector<int> find_textures(const std::string& name, const Header& header, bool has_uvs, SideTextures& textures,
                               const Context& context) {
  std::vector<int> found;
  if (has_uvs) {
    for (const std::string& file : header.texture_files) found.push_back(textures.add(file, name));
    if (header.texture_files.empty())
      context.warning(
          fmt::format("{}: has texture coordinates but no texture; add \"comment TextureFile NAME\" to its "
                      "header.",
                      name));
  } else if (!header.texture_files.empty()) {
    context.warning(fmt::format("{}: has no texture coordinates, so its texture {} is left out.", name,
                                shown(header.texture_files.front())));
  }
  return found;
}

}  // namespace

void read_mesh(const std::string& name, const Header& header, Body& body, SideTextures& textures, const Context& context,
               Scene& scene) {
  PlyMesh ply = read_elements(name, header, body, scene.origin, context);
  const std::vector<int> found = find_textures(name, header, !ply.mesh.uvs.empty() || ply.own.uvs, textures, context);
  bool replaced = false;
  for (auto& [number, mesh] : parts_of(ply, header)) {
    const auto i = static_cast<std::size_t>(number);
    const int texture = number >= 0 && i < found.size() ? found[i] : -1;
    if (texture >= 0 && !mesh.colors.empty()) mesh.colors.clear(), replaced = true;
    wind_by_normals(mesh);
    add_instance(std::move(mesh), texture, scene);
  }
  if (replaced)
    context.warning(fmt::format("{}: the properties red, green and blue are left out: the texture replaces them.", name));
}

}  // namespace lippmann::ply
