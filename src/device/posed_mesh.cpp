#include "device/posed_mesh.hpp"

#include <algorithm>

namespace lippmann {

std::vector<UvGradient> make_uv_gradients(const Mesh& mesh, const std::vector<Vec2f>& uvs) {
  std::vector<UvGradient> gradients;
  gradients.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3f edge_b = mesh.positions[b] - mesh.positions[a], edge_c = mesh.positions[c] - mesh.positions[a];
    const Vec2f uv_b = uvs[b] - uvs[a], uv_c = uvs[c] - uvs[a];
    const Vec3f n = glm::cross(edge_b, edge_c);
    const float squared = glm::dot(n, n);
    if (!(squared > 0.0f)) {
      gradients.push_back({Vec3f(0.0f), Vec3f(0.0f), Vec3f(0.0f)});
      continue;
    }
    // Gradients of the barycentric coordinates of corners b and c
    const Vec3f to_b = glm::cross(edge_c, n) / squared, to_c = glm::cross(n, edge_b) / squared;
    gradients.push_back({uv_b.x * to_b + uv_c.x * to_c, uv_b.y * to_b + uv_c.y * to_c, n / std::sqrt(squared)});
  }
  return gradients;
}

void pose_vertices(const MeshPose& pose, PosedMesh& posed, const ThreadPool& pool) {
  constexpr std::size_t kPiece = 4096;
  Mesh& mesh = posed.mesh;
  const std::size_t vertices = mesh.positions.size();
  pool.for_each((vertices + kPiece - 1) / kPiece, [&](std::size_t piece) {
    for (std::size_t i = piece * kPiece; i < std::min(vertices, (piece + 1) * kPiece); ++i) {
      const PosedVertex v = pose.vertex(i);
      mesh.positions[i] = v.position;
      if (!mesh.normals.empty()) mesh.normals[i] = posed.mirrored ? -v.normal : v.normal;
      if (!mesh.tangents.empty()) mesh.tangents[i] = posed.mirrored ? Vec4f(Vec3f(v.tangent), -v.tangent.w) : v.tangent;
    }
  });
  for (int set = 0; set < 2; ++set)
    if (const std::vector<Vec2f>& uvs = uvs_of(mesh, set); !uvs.empty())
      posed.uv_gradients[static_cast<std::size_t>(set)] = make_uv_gradients(mesh, uvs);
}

void store_vertices(const Mesh& mesh, const EmbreeGeometry& geometry) {
  void* vertices = rtcGetGeometryBufferData(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0);
  std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3f*>(vertices));
  rtcUpdateGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0);
  rtcCommitGeometry(geometry.get());
}

}  // namespace lippmann
