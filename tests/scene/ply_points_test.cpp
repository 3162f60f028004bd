#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/ply.hpp"
#include "scene/splats.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using ::testing::HasSubstr;

constexpr const char* kBytes = "property uchar red\nproperty uchar green\nproperty uchar blue\n";

std::string points_text(const std::vector<std::string>& rows, const std::string& properties = {},
                        const std::string& comment = {}) {
  std::string text = "ply\nformat ascii 1.0\n" + comment + "element vertex " + std::to_string(rows.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\n" + properties + "end_header\n";
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

Scene points_scene(const std::string& text, double size = 0.0, std::vector<std::string>* warnings = nullptr) {
  Context context;
  context.warn = [&](std::string_view warning) {
    if (warnings) warnings->emplace_back(warning);
  };
  PlyOptions options;
  options.point_size = size;
  Scene scene = parse_ply("a.ply", text, context, options);
  validate(scene, "a.ply");
  return scene;
}

const Splats& point_splats(const Scene& scene) { return std::get<Splats>(scene.shapes.at(0)); }
const Spheres& point_spheres(const Scene& scene) { return std::get<Spheres>(scene.shapes.at(0)); }

std::vector<std::string> point_grid(int side, const std::string& more = {}) {
  std::vector<std::string> rows;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) rows.push_back(std::to_string(0.5 * x) + " " + std::to_string(0.5 * y) + " 0 " + more);
  return rows;
}

TEST(PlyPoints, colours_make_splats_that_nothing_lights) {
  const Scene scene = points_scene(points_text({"1 2 3 255 0 51"}, kBytes), 0.4);
  const Splats& points = point_splats(scene);
  EXPECT_EQ(scene.kind, SceneKind::kSplats);
  EXPECT_EQ(points.centers.at(0), Vec3f(1.0f, 2.0f, 3.0f));
  const Vec3f color = 0.5f + points.harmonics.at(0) / std::sqrt(4.0f * kPi);
  EXPECT_NEAR(color.x, 1.0f, 1e-6f);
  EXPECT_NEAR(color.y, 0.0f, 1e-6f);
  EXPECT_NEAR(color.z, 0.2f, 1e-6f);
  EXPECT_EQ(points.opacities.at(0), 1.0f);
  EXPECT_FALSE(points.is_linear);
}

TEST(PlyPoints, size_is_the_width_at_half_coverage) {
  const Scene scene = points_scene(points_text({"0 0 0 9 9 9"}, kBytes), 0.4);
  const float deviations = 0.2f / point_splats(scene).deviations.at(0).x;
  EXPECT_NEAR(std::exp(-0.5f * deviations * deviations), 0.5f, 1e-5f);
}

TEST(PlyPoints, without_colours_are_spheres) {
  const Scene scene = points_scene(points_text({"1 2 3", "4 5 6"}), 0.5);
  ASSERT_EQ(point_spheres(scene).size(), 2u);
  EXPECT_EQ(point_spheres(scene).at(0).radius, 0.25f);
  EXPECT_EQ(scene.kind, SceneKind::kPhysical);
}

TEST(PlyPoints, spacing_decides_the_size) {
  EXPECT_NEAR(point_spheres(points_scene(points_text(point_grid(20)))).at(0).radius, 0.5f * 2.0f * 0.5f, 1e-6f);
  std::vector<std::string> twice = point_grid(20);
  twice.insert(twice.end(), twice.begin(), twice.begin() + 100);
  twice.push_back("10000 0 0");
  EXPECT_NEAR(point_spheres(points_scene(points_text(twice))).at(0).radius, 0.5f * 2.0f * 0.5f, 1e-6f);
  EXPECT_EQ(point_spheres(points_scene(points_text({"1 2 3", "1 2 3"}))).at(0).radius, 0.5f);
  std::vector<std::string> colored = point_grid(20);
  for (std::string& row : colored) row += " 9 9 9";
  EXPECT_NEAR(point_splats(points_scene(points_text(colored, kBytes))).deviations.at(0).x, 1.6f * 0.5f / 2.35482f, 1e-6f);
}

TEST(PlyPoints, elements_of_no_rows_are_no_faces) {
  std::string text = points_text({"1 2 3"});
  text.insert(text.find("end_header"), "element face 0\nproperty list uchar int vertex_indices\n");
  EXPECT_EQ(point_spheres(points_scene(text)).size(), 1u);
}

TEST(PlyPoints, counts_values_that_are_not_finite) {
  std::vector<std::string> warnings;
  EXPECT_EQ(point_spheres(points_scene(points_text({"nan nan nan", "1 2 3", "inf 0 0"}), 0.0, &warnings)).size(), 1u);
  EXPECT_THAT(warnings, testing::Contains(HasSubstr("2 points are left out")));
  EXPECT_THAT(test::error_message([] { points_scene(points_text({"nan nan nan"})); }), HasSubstr("has no points to show"));
}

TEST(PlyPoints, a_vertical_axis_z_is_turned_upwards) {
  const Scene scene = points_scene(points_text({"0 0 1"}, {}, "comment Vertical Axis: z\n"));
  const Affine3f world = evaluate(scene, 0.0).of(scene.instances.at(0).node);
  EXPECT_LT(glm::distance(transform_point(world, point_spheres(scene).at(0).center), Vec3f(0.0f, 1.0f, 0.0f)), 1e-6f);
}

TEST(PlyPoints, far_from_the_origin_keep_their_digits) {
  const test::TempDir dir;
  std::ofstream(dir / "a.ply") << points_text({"4500000 0 0", "4500000.001 0 0"});
  const Scene scene = load_scene((dir / "a.ply").string(), {}, Context{});
  EXPECT_NEAR(glm::distance(point_spheres(scene).at(0).center, point_spheres(scene).at(1).center), 0.001f, 1e-6f);
}

TEST(PlyPoints, kind_is_known_from_the_header) {
  const test::TempDir dir;
  std::ofstream(dir / "grey.ply") << points_text({"1 2 3"});
  std::ofstream(dir / "red.ply") << points_text({"1 2 3 255 0 0"}, kBytes);
  EXPECT_EQ(scene_kind((dir / "grey.ply").string()), SceneKind::kPhysical);
  EXPECT_EQ(scene_kind((dir / "red.ply").string()), SceneKind::kSplats);
}

TEST(PlyPoints, size_is_rejected_with_faces) {
  const test::TempDir dir;
  std::ofstream(dir / "mesh.ply") << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                     "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                                     "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::ofstream(dir / "scene.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  LoadOptions options;
  options.point_size = 1.0;
  for (const char* name : {"mesh.ply", "scene.obj"})
    EXPECT_THAT(test::error_message([&] { load_scene((dir / name).string(), options, Context{}); }),
                HasSubstr("is not a point cloud; accepted: a PLY file without faces"));
}

}  // namespace
}  // namespace lippmann
