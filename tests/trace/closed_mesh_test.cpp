#include "shading/closed_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <limits>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

void add_face(Mesh& mesh, int axis, float sign, float half) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& [u, v] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
    Vec3f at(0.0f);
    at[axis] = sign * half, at[(axis + 1) % 3] = sign * u * half, at[(axis + 2) % 3] = v * half;
    mesh.positions.push_back(at);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

Mesh cube(float half) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f}) add_face(mesh, axis, sign, half);
  return mesh;
}

Mesh turned_inside_out(Mesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

TEST(ClosedMesh, orientation_of_a_cube_is_detected) {
  EXPECT_EQ(facing_of_closed(cube(1.0f)), BodyFacing::kOutward);
  EXPECT_EQ(facing_of_closed(turned_inside_out(cube(1.0f))), BodyFacing::kInward);
  EXPECT_EQ(facing_of_closed(cube(1e-4f)), BodyFacing::kOutward);
  EXPECT_EQ(facing_of_closed(cube(1e6f)), BodyFacing::kOutward);
}

TEST(ClosedMesh, seam_vertices_are_merged) {
  Mesh mesh = cube(1.0f);
  for (std::size_t v = 0; v < 4; ++v) mesh.positions[v] *= 1.0f + 2e-7f;
  EXPECT_EQ(facing_of_closed(mesh), BodyFacing::kOutward);
  for (std::size_t v = 0; v < 4; ++v) mesh.positions[v] *= 1.01f;
  EXPECT_EQ(facing_of_closed(mesh), BodyFacing::kNone);
}

TEST(ClosedMesh, triangles_without_area_are_ignored) {
  Mesh mesh = cube(1.0f);
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_EQ(facing_of_closed(mesh), BodyFacing::kOutward);
}

TEST(ClosedMesh, open_and_inconsistent_meshes_are_not_closed) {
  Mesh hole = cube(1.0f);
  hole.triangles.pop_back();
  EXPECT_EQ(facing_of_closed(hole), BodyFacing::kNone);
  Mesh turned = cube(1.0f);
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  EXPECT_EQ(facing_of_closed(turned), BodyFacing::kNone);
  Mesh twice = cube(1.0f);
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.begin() + 12);
  EXPECT_EQ(facing_of_closed(twice), BodyFacing::kNone);
  EXPECT_EQ(facing_of_closed(square(1.0f, 0.0f)), BodyFacing::kNone);
  Mesh sheet = square(1.0f, 0.0f);
  for (const auto& t : square(1.0f, 0.0f).triangles) sheet.triangles.push_back({t[0], t[2], t[1]});
  EXPECT_EQ(facing_of_closed(sheet), BodyFacing::kNone) << "it has no volume";
  EXPECT_EQ(facing_of_closed(Mesh{}), BodyFacing::kNone);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Mesh mesh = cube(1.0f);
    mesh.positions[5].y = bad;
    EXPECT_EQ(facing_of_closed(mesh), BodyFacing::kNone);
  }
}

/// The cube is one closed mesh, or six separate squares, which give the same picture.
SmallScene below_cube(bool is_closed, bool is_mirrored = false) {
  SmallScene s;
  MetallicRoughness floor, shines;
  floor.metallic = 0.0f, floor.roughness = 1.0f, floor.specular = 0.0f;
  shines = floor;
  shines.base_color = Vec4f(0, 0, 0, 1), shines.emissive = Vec3f(40.0f);
  s.add(square(2, 0), s.material(floor));
  const int material = s.material(shines);
  const auto lift = [&](Mesh mesh) {
    if (is_mirrored) mesh = turned_inside_out(mesh);
    for (Vec3f& p : mesh.positions) p += Vec3f(0.7f, 0.3f, 1.5f);
    s.add(mesh, material);
  };
  if (is_closed) lift(cube(0.2f));
  for (int axis = 0; !is_closed && axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f}) {
      Mesh face;
      add_face(face, axis, sign, 0.2f);
      lift(face);
    }
  return s;
}

// The eye at (0, 0, 1) sees the square from -0.2 to 0.2 in x and y at z = 0.
const Affine3f kEye{Mat3f(0.1f), Vec3f(0.0f)};

Image floor_below(const SmallScene& s, int spp) { return trace_paths(s.scene, single_view(16), spp, {}, 1, kEye).film; }

double squared_error(const Image& film, const Image& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < film.data.size(); ++i) {
    const auto d = static_cast<double>(film.data[i] - truth.data[i]);
    sum += d * d;
  }
  return sum;
}

// About half of a cube's faces point away from a point of the floor. Shadow rays rarely sample these faces of a closed
// lamp.
TEST(ClosedMesh, closed_lamps_have_less_noise) {
  const Image truth = floor_below(below_cube(false), 4096);
  for (const bool is_mirrored : {false, true}) {
    const SmallScene closed = below_cube(true, is_mirrored);
    EXPECT_NEAR(mean(floor_below(closed, 1024)), mean(truth), 0.003 * mean(truth));
    EXPECT_LT(squared_error(floor_below(closed, 8), truth), 0.6 * squared_error(floor_below(below_cube(false), 8), truth));
  }
}

SmallScene below_small_cube(float half) {
  SmallScene s;
  MetallicRoughness floor, shines;
  floor.metallic = 0.0f, floor.roughness = 1.0f, floor.specular = 0.0f;
  shines = floor;
  shines.base_color = Vec4f(0, 0, 0, 1), shines.emissive = Vec3f(1.0f / (half * half));
  s.add(square(2, 0), s.material(floor));
  Mesh lamp = cube(half);
  for (Vec3f& p : lamp.positions) p += Vec3f(0.7f, 0.3f, 1.5f);
  s.add(lamp, s.material(shines));
  return s;
}

// Shadow rays end slightly before the light, so near an edge they may reach the far side of a small lamp. The far side
// is sampled so rarely that each such ray would leave a white dot.
TEST(ClosedMesh, small_lamps_do_not_leak_at_edges) {
  const Image film = trace_paths(below_small_cube(0.001f).scene, single_view(64), 4, {}, 1, kEye).film;
  const float brightest = *std::max_element(film.data.begin(), film.data.end());
  EXPECT_LT(static_cast<double>(brightest), 2.0 * mean(film));
}

// From within, all faces show their inner side, so none may be excluded.
TEST(ClosedMesh, inward_glowing_rooms_give_light) {
  SmallScene s;
  MetallicRoughness grey, shines;
  grey.metallic = 0.0f, grey.roughness = 1.0f, grey.specular = 0.0f;
  shines = grey;
  shines.base_color = Vec4f(0, 0, 0, 1), shines.emissive = Vec3f(1.0f);
  s.add(square(0.5f, 0), s.material(grey));
  s.add(cube(3.0f), s.material(shines));
  // In uniform light, the radiance of a matte floor is its albedo times the radiance of the light.
  const auto albedo = static_cast<double>(grey.base_color.x);
  EXPECT_NEAR(mean(floor_below(s, 256)), albedo, 0.01 * albedo);
}

}  // namespace
}  // namespace lippmann
