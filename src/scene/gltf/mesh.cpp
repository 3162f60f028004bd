// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 3.7.2.1, which defines the attributes and the vertex order
// of strips and fans. Triangle i has the following vertices.
// - Strip: v_i, v_(i + 1 + i%2), v_(i + 2 - i%2).
// - Fan: v_(i + 1), v_(i + 2), v_0.
#include "scene/gltf/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/gltf/accessor.hpp"
#include "scene/gltf/skin.hpp"

namespace lippmann::gltf {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::vector<std::uint32_t> read_corners(Document& document, PrimitiveId id, std::size_t vertices) {
  const int indices = primitive_of(document, id)["indices"].index();
  if (indices < 0) {
    document.unpacked.spend(vertices, sizeof(std::uint32_t), element(id), document.report);
    std::vector<std::uint32_t> corners(vertices);
    std::iota(corners.begin(), corners.end(), 0u);
    return corners;
  }
  std::vector<std::uint32_t> corners = unpack_unsigned<std::uint32_t>(document, indices);
  const auto bad = std::find_if(corners.begin(), corners.end(), [&](std::uint32_t corner) { return corner >= vertices; });
  if (bad != corners.end())
    document.report.fail(element(id), fmt::format("index {} is {}", bad - corners.begin(), *bad),
                         fmt::format("0 to {}", vertices - 1));
  return corners;
}

std::vector<Triangle> assemble(const std::vector<std::uint32_t>& v, Mode mode) {
  std::vector<Triangle> triangles;
  if (mode == Mode::kTriangles) {
    triangles.reserve(v.size() / 3);
    for (std::size_t i = 0; i + 2 < v.size(); i += 3) triangles.push_back({v[i], v[i + 1], v[i + 2]});
    return triangles;
  }
  triangles.reserve(v.size());
  const bool strip = mode == Mode::kTriangleStrip;
  for (std::size_t i = 0; i + 2 < v.size(); ++i)
    triangles.push_back(strip ? Triangle{v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]} : Triangle{v[i + 1], v[i + 2], v[0]});
  return triangles;
}

/// A normal of zero length is replaced by the mean normal of the vertex's triangles, weighted by area.
void normalize_normals(Mesh& mesh, const std::string& where, Report& report) {
  std::vector<std::uint32_t> missing;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const float longest = std::max({std::abs(mesh.normals[i].x), std::abs(mesh.normals[i].y), std::abs(mesh.normals[i].z)});
    if (longest > 0.0f)
      mesh.normals[i] = glm::normalize(mesh.normals[i] / longest);
    else
      missing.push_back(static_cast<std::uint32_t>(i));
  }
  if (missing.empty()) return;
  report.warn_at("zero-length normals are replaced by those of the triangles", where);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t corner : t)
      if (std::binary_search(missing.begin(), missing.end(), corner))
        mesh.normals[corner] +=
            glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
  for (const std::uint32_t i : missing) {
    const float length = glm::length(mesh.normals[i]);
    mesh.normals[i] = length > 0.0f && std::isfinite(length) ? mesh.normals[i] / length : Vec3f(0.0f, 0.0f, 1.0f);
  }
}

}  // namespace

std::optional<Mesh> read_mesh(Document& document, PrimitiveId id, const MaterialNeeds& needs) {
  const Value primitive = primitive_of(document, id);
  if (mode_of(primitive) < Mode::kTriangles) {
    document.report.not_supported("points and lines are", "they are left out", element(id));
    return std::nullopt;
  }
  if (attribute(primitive, "POSITION") < 0) {
    document.report.warn_at("primitives without positions are left out", element(id));
    return std::nullopt;
  }

  warn_about_unread_attributes(document, id);
  Mesh mesh;
  mesh.positions = unpack<Vec3f>(document, attribute(primitive, "POSITION"));
  const std::size_t vertices = mesh.positions.size();
  mesh.normals = read_attribute<Vec3f>(document, id, "NORMAL", vertices);
  const auto uvs = [&](int set) { return read_attribute<Vec2f>(document, id, fmt::format("TEXCOORD_{}", set), vertices); };
  mesh.uvs = uvs(needs.uv_sets[0]);
  if (needs.uv_sets[1] >= 0) mesh.uvs_1 = uvs(needs.uv_sets[1]);
  read_colors(document, id, mesh);
  if (needs.tangents) read_tangents(document, id, mesh);
  const std::vector<std::uint32_t> corners = read_corners(document, id, vertices);
  document.unpacked.spend(corners.size(), sizeof(Triangle), element(id), document.report);
  mesh.triangles = assemble(corners, mode_of(primitive));
  normalize_normals(mesh, element(id), document.report);
  read_targets(document, id, mesh);
  return mesh;
}

}  // namespace lippmann::gltf
