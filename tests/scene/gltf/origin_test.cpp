// Transforms of scenes far from the origin must be composed in double precision before conversion to floats.
#include "lippmann/scene/origin.hpp"

#include <gtest/gtest.h>

#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/gltf/gltf_builder.hpp"

namespace lippmann {
namespace {

using test::GltfBuilder;
using test::Json;
using test::parse;

/// A place so far from the origin that floats have a spacing of half a unit.
const Vec3d kPlace(4512345.123, 320.57, -5400000.71);
/// rounding errors of coordinates below 16, and of the 17 digits in the file
constexpr double kRounding = 2e-6;

void expect_near(Vec3d a, Vec3d b) {
  EXPECT_LE(glm::length(a - b), kRounding) << a.x << " " << a.y << " " << a.z << " and " << b.x << " " << b.y << " " << b.z;
}

Vec3d in_file(const Scene& scene, int node, Vec3f p = Vec3f(0.0f)) {
  return scene.origin + Vec3d(transform_point(evaluate(scene, 0.0).of(node), p));
}

Vec3d first_corner(const Scene& scene) {
  const Instance& instance = scene.instances.at(0);
  return in_file(scene, instance.node,
                 std::get<Mesh>(scene.shapes.at(static_cast<std::size_t>(instance.shape))).positions.at(0));
}

Json json_of(Vec3d v) { return {v.x, v.y, v.z}; }

Scene parse_valid(const GltfBuilder& b) {
  Scene scene = parse(b);
  validate(scene, "a.glb");
  return scene;
}

TEST(GltfOrigin, translation_keeps_the_digits_of_the_file) {
  GltfBuilder b;
  b.add_node({{"mesh", b.add_triangle()}, {"translation", json_of(kPlace)}});
  const Scene scene = parse_valid(b);
  EXPECT_NE(scene.origin, Vec3d(0.0));
  expect_near(first_corner(scene), kPlace);
}

TEST(GltfOrigin, matrix_keeps_the_digits_of_the_file) {
  GltfBuilder b;
  b.add_node({{"mesh", b.add_triangle()}, {"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 1, 0, kPlace.x, kPlace.y, kPlace.z, 1}}});
  expect_near(first_corner(parse_valid(b)), kPlace);
}

TEST(GltfOrigin, composes_scaled_roots_in_double) {
  GltfBuilder b;
  const double half = 0.70710678118654752440;
  // The root rotates z to y and converts centimetres to metres, as exporters with z up do.
  b.add_node({{"rotation", {-half, 0, 0, half}}, {"scale", {0.01, 0.01, 0.01}}, {"children", {1}}});
  b.add_node({{"translation", {100 * kPlace.x, -100 * kPlace.z, 100 * kPlace.y}}, {"children", {2}}});
  b.add_node({{"mesh", b.add_triangle()}, {"scale", {100, 100, 100}}});
  b.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  b.add_node({{"camera", 0}, {"translation", json_of(kPlace + Vec3d(0.25, 0.5, 7.125))}});
  const Scene scene = parse_valid(b);
  expect_near(first_corner(scene), kPlace);
  expect_near(in_file(scene, scene.cameras.at(0).node), kPlace + Vec3d(0.25, 0.5, 7.125));
}

TEST(GltfOrigin, composes_cancelling_translations_in_double) {
  GltfBuilder b;
  b.add_node({{"translation", json_of(16.0 * kPlace)}, {"children", {1}}});
  b.add_node({{"translation", json_of(-15.0 * kPlace)}, {"mesh", b.add_triangle()}});
  expect_near(first_corner(parse_valid(b)), kPlace);
}

TEST(GltfOrigin, coordinates_in_vertices_move_with_it) {
  const Vec3f far(4512345.5f, 320.5f, -5400000.5f);
  GltfBuilder b;
  const int positions = b.add_accessor(std::vector<Vec3f>{far, far + Vec3f(1, 0, 0), far + Vec3f(0, 1, 0)});
  b.add_node({{"mesh", b.add_mesh({{"attributes", {{"POSITION", positions}}}})}});
  const Scene scene = parse_valid(b);
  expect_near(first_corner(scene), Vec3d(far));
  EXPECT_LT(glm::length(std::get<Mesh>(scene.shapes.at(0)).positions[0]), 4.0f);
}

TEST(GltfOrigin, animated_translation_moves_with_it) {
  GltfBuilder b;
  const Vec3f far(4512345.5f, 320.5f, -5400000.5f);
  b.add_node({{"mesh", b.add_triangle()}, {"translation", json_of(Vec3d(far))}});
  const int times = b.add_accessor(std::vector<float>{0.0f, 1.0f});
  const int values = b.add_accessor(std::vector<Vec3f>{far, far + Vec3f(4, 0, 0)});
  b.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                       {"samplers", {{{"input", times}, {"output", values}}}}});
  const Scene scene = parse_valid(b);
  expect_near(scene.origin + Vec3d(evaluate(scene, 0.0).of(0).translation), Vec3d(far));
  expect_near(scene.origin + Vec3d(evaluate(scene, 0.25).of(0).translation), Vec3d(far) + Vec3d(1, 0, 0));
}

TEST(GltfOrigin, scenes_near_the_origin_keep_it) {
  GltfBuilder b;
  // The origin moves if a scene is farther away than 64 of its diagonals, which are 90 units for the triangle.
  b.add_node({{"mesh", b.add_triangle()}, {"translation", {60, 0, 0}}});
  const Scene scene = parse_valid(b);
  EXPECT_EQ(scene.origin, Vec3d(0.0));
  EXPECT_EQ(scene.nodes[0].local.translation, Vec3f(60, 0, 0));
}

}  // namespace
}  // namespace lippmann
