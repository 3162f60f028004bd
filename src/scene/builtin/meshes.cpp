#include "scene/builtin/meshes.hpp"

#include <cmath>
#include <cstdint>

namespace lippmann::builtin {
namespace {

using Index = std::uint32_t;

Index vertex_count(const Mesh& mesh) { return static_cast<Index>(mesh.positions.size()); }

/// Adds the two triangles of a grid cell, unless they have no area.
void add_cell(Mesh& mesh, Index a, Index b, Index c, Index d) {
  const auto same = [&](Index i, Index j) { return mesh.positions[i] == mesh.positions[j]; };
  if (!same(a, b) && !same(b, c) && !same(a, c)) mesh.triangles.push_back({a, b, c});
  if (!same(a, c) && !same(c, d) && !same(a, d)) mesh.triangles.push_back({a, c, d});
}

Vec2f unit_or_zero(Vec2f v) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : Vec2f(0.0f);
}

/// Returns the outward normals (radial, y) of a profile's points. At a crease, a point is listed twice, with the normals of the
/// segments before and after it.
std::vector<Vec2f> profile_normals(const std::vector<Vec2f>& profile) {
  const std::size_t n = profile.size();
  const bool loop = n > 2 && profile.front() == profile.back();
  std::vector<Vec2f> normals(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2f before = i > 0 ? profile[i - 1] : loop ? profile[n - 2] : profile[i];
    const Vec2f after = i + 1 < n ? profile[i + 1] : loop ? profile[1] : profile[i];
    const Vec2f tangent = unit_or_zero(profile[i] - before) + unit_or_zero(after - profile[i]);
    normals[i] = glm::normalize(Vec2f(tangent.y, -tangent.x));
  }
  return normals;
}

Vec2f catmull_rom(Vec2f a, Vec2f b, Vec2f c, Vec2f d, float t) {
  return 0.5f * (2.0f * b + t * (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a))));
}

Vec3f any_perpendicular(Vec3f v) {
  return glm::normalize(glm::cross(v, std::abs(v.x) < 0.7f ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0)));
}

Vec3f perpendicular_part(Vec3f v, Vec3f axis) { return glm::normalize(v - glm::dot(v, axis) * axis); }

std::vector<Vec3f> curve_tangents(const std::vector<Vec3f>& points, bool closed) {
  const std::size_t n = points.size();
  std::vector<Vec3f> tangents(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3f& before = points[i > 0 ? i - 1 : closed ? n - 1 : 0];
    const Vec3f& after = points[i + 1 < n ? i + 1 : closed ? 0 : i];
    tangents[i] = glm::normalize(after - before);
  }
  return tangents;
}

std::vector<Vec3f> transported_normals(const std::vector<Vec3f>& tangents) {
  std::vector<Vec3f> normals{any_perpendicular(tangents[0])};
  for (std::size_t i = 1; i < tangents.size(); ++i) normals.push_back(perpendicular_part(normals.back(), tangents[i]));
  return normals;
}

/// Parallel transport once around a closed curve rotates a normal. Returns the angle that undoes this rotation.
float closing_twist(const std::vector<Vec3f>& tangents, const std::vector<Vec3f>& normals) {
  const Vec3f arrived = perpendicular_part(normals.back(), tangents[0]);
  return std::atan2(glm::dot(glm::cross(arrived, normals[0]), tangents[0]), glm::dot(arrived, normals[0]));
}

}  // namespace

void append(Mesh& mesh, const Mesh& part, const Affine3f& placement) {
  const Index first = vertex_count(mesh);
  for (const Vec3f& p : part.positions) mesh.positions.push_back(transform_point(placement, p));
  for (const Vec3f& n : part.normals) mesh.normals.push_back(glm::normalize(transform_normal(placement, n)));
  mesh.uvs.insert(mesh.uvs.end(), part.uvs.begin(), part.uvs.end());
  for (const auto& t : part.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

Mesh lathe(const std::vector<Vec2f>& profile, int segments) {
  Mesh mesh;
  const std::vector<Vec2f> normals = profile_normals(profile);
  const Index columns = static_cast<Index>(segments) + 1;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    for (Index j = 0; j < columns; ++j) {
      // j modulo segments makes the last column equal to the first one exactly, so that the seam has no gap.
      const float angle = 2.0f * kPi * static_cast<float>(j % static_cast<Index>(segments)) / static_cast<float>(segments);
      const Vec3f outwards(std::sin(angle), 0.0f, std::cos(angle));
      mesh.positions.push_back(profile[i].x * outwards + Vec3f(0.0f, profile[i].y, 0.0f));
      mesh.normals.push_back(glm::normalize(normals[i].x * outwards + Vec3f(0.0f, normals[i].y, 0.0f)));
      mesh.uvs.push_back({static_cast<float>(j) / static_cast<float>(segments),
                          1.0f - static_cast<float>(i) / static_cast<float>(profile.size() - 1)});
    }
  }
  for (Index i = 0; i + 1 < profile.size(); ++i)
    for (Index j = 0; j + 1 < columns; ++j) {
      const Index a = i * columns + j, d = a + columns;
      add_cell(mesh, a, a + 1, d + 1, d);
    }
  return mesh;
}

std::vector<Vec2f> smooth_profile(const std::vector<Vec2f>& points, int steps) {
  std::vector<Vec2f> profile;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Vec2f b = points[i], c = points[i + 1];
    profile.push_back(b);
    if (b == c) continue;
    const Vec2f a = i > 0 && points[i - 1] != b ? points[i - 1] : 2.0f * b - c;
    const Vec2f d = i + 2 < n && points[i + 2] != c ? points[i + 2] : 2.0f * c - b;
    for (int s = 1; s < steps; ++s)
      profile.push_back(catmull_rom(a, b, c, d, static_cast<float>(s) / static_cast<float>(steps)));
  }
  profile.push_back(points.back());
  return profile;
}

Mesh tube(const std::vector<Vec3f>& points, const std::vector<float>& radii, int sides, bool closed) {
  Mesh mesh;
  const std::vector<Vec3f> tangents = curve_tangents(points, closed);
  const std::vector<Vec3f> normals = transported_normals(tangents);
  const float twist = closed ? closing_twist(tangents, normals) : 0.0f;
  const Index rows = static_cast<Index>(points.size()), columns = static_cast<Index>(sides) + 1;
  const Index spans = closed ? rows : rows - 1;
  for (Index row = 0; row <= spans; ++row) {
    const Index i = row % rows;
    const Vec3f binormal = glm::cross(tangents[i], normals[i]);
    const float along = static_cast<float>(row) / static_cast<float>(spans);
    for (Index j = 0; j < columns; ++j) {
      const float around = static_cast<float>(j % static_cast<Index>(sides)) / static_cast<float>(sides);
      const float angle = 2.0f * kPi * around + twist * static_cast<float>(i) / static_cast<float>(rows);
      const Vec3f outwards = std::cos(angle) * normals[i] + std::sin(angle) * binormal;
      mesh.positions.push_back(points[i] + radii[i] * outwards);
      mesh.normals.push_back(glm::normalize(outwards));
      mesh.uvs.push_back({static_cast<float>(j) / static_cast<float>(sides), along});
    }
  }
  for (Index row = 0; row < spans; ++row)
    for (Index j = 0; j + 1 < columns; ++j) {
      const Index a = row * columns + j, d = a + columns;
      add_cell(mesh, a, a + 1, d + 1, d);
    }
  return mesh;
}

Mesh torus(float major_radius, float minor_radius, int segments, int sides) {
  std::vector<Vec2f> profile;
  for (int i = 0; i <= sides; ++i) {
    const float angle = 2.0f * kPi * static_cast<float>(i % sides) / static_cast<float>(sides);
    profile.push_back({major_radius + minor_radius * std::cos(angle), minor_radius * std::sin(angle)});
  }
  return lathe(profile, segments);
}

Mesh cone(float radius, float height, int segments) {
  return lathe({{0.0f, 0.0f}, {radius, 0.0f}, {radius, 0.0f}, {0.0f, height}}, segments);
}

Mesh uv_sphere(float radius, int segments, int rings) {
  std::vector<Vec2f> profile{{0.0f, -radius}};
  for (int i = 1; i < rings; ++i) {
    const float angle = kPi * (static_cast<float>(i) / static_cast<float>(rings) - 0.5f);
    profile.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  profile.push_back({0.0f, radius});
  Mesh mesh = lathe(profile, segments);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.normals[i] = mesh.positions[i] / radius;
  return mesh;
}

Mesh disc(float radius, int segments, float uv_size) {
  Mesh mesh = lathe({{radius, 0.0f}, {0.0f, 0.0f}}, segments);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.uvs[i] = Vec2f(mesh.positions[i].x, mesh.positions[i].z) / uv_size;
  return mesh;
}

Mesh rectangle(Vec3f center, Vec3f half_u, Vec3f half_v, Vec2f repeats) {
  const Vec3f normal = glm::normalize(glm::cross(half_u, half_v));
  Mesh mesh;
  mesh.positions = {center - half_u - half_v, center + half_u - half_v, center + half_u + half_v, center - half_u + half_v};
  mesh.normals.assign(4, normal);
  mesh.uvs = {{0.0f, repeats.y}, {repeats.x, repeats.y}, {repeats.x, 0.0f}, {0.0f, 0.0f}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

}  // namespace lippmann::builtin
