#include "scene/nff.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/nff/cone.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using ::testing::HasSubstr;

Scene nff_scene(const std::string& text) {
  Scene scene = parse_nff("a.nff", text, Context{});
  validate(scene, "a.nff");
  return scene;
}

std::string nff_error(const std::string& text) {
  return test::error_message([&] { nff_scene(text); });
}

template <class S>
const S& shape(const Scene& scene, std::size_t instance) {
  return std::get<S>(scene.shapes.at(static_cast<std::size_t>(scene.instances.at(instance).shape)));
}

const PhongSurface& surface(const Scene& scene, std::size_t instance) {
  return std::get<PhongSurface>(scene.materials.at(static_cast<std::size_t>(scene.instances.at(instance).material)).surface);
}

TEST(Nff, spheres_of_one_fill_are_one_shape) {
  const Scene scene =
      nff_scene("f 1 0 0 1 0 1 0 1\ns 0 0 0 1\ns 1 2 3 -4\nf 0 1 0 1 0 1 0 1\ns 5 5 5 1\nf 1 0 0 1 0 1 0 1\ns 9 9 9 1");
  ASSERT_EQ(scene.instances.size(), 2u);
  const Spheres& red = shape<Spheres>(scene, 0);
  ASSERT_EQ(red.size(), 3u);  // the fill statement before the third sphere repeats the current fill
  EXPECT_EQ(red[1].center, Vec3f(1, 2, 3));
  EXPECT_EQ(red[1].radius, 4.0f);  // the file has the radius -4, for a sphere seen from inside
  EXPECT_EQ(shape<Spheres>(scene, 1).size(), 1u);
}

TEST(Nff, fill_sets_highlight_mirror_and_transparency) {
  const Scene scene = nff_scene("f 0.1 0.2 0.3 0.8 0.25 5 0.75 1.5\ns 0 0 0 1");
  const PhongSurface& s = surface(scene, 0);
  EXPECT_EQ(s.color, Vec3f(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(s.ambient, 0.0f);
  EXPECT_EQ(s.diffuse, 0.8f);
  EXPECT_EQ(s.highlight_kind, Highlight::kPlastic);
  EXPECT_EQ(s.highlight, 0.25f);
  EXPECT_EQ(s.highlight_size, 20.0f);  // four times the exponent of 5 in the file
  EXPECT_EQ(s.mirror, 0.25f);
  EXPECT_EQ(s.opacity, 0.25f);
  EXPECT_EQ(s.ior, 1.5f);
}

TEST(Nff, opaque_fill_needs_no_index_of_refraction) {
  EXPECT_EQ(surface(nff_scene("f 1 1 1 1 0 1 0 0\ns 0 0 0 1"), 0).ior, 1.0f);
  EXPECT_THAT(nff_error("f 1 1 1 1 0 1 0.5 0\ns 0 0 0 1"), HasSubstr("a.nff:1: the index of refraction"));
}

TEST(Nff, equal_radii_give_a_cylinder) {
  const Scene scene = nff_scene("c 0 0 0 0.5\n0 0 2 0.5");
  const Cylinder& c = shape<Cylinders>(scene, 0).at(0);
  EXPECT_EQ(c.base, Vec3f(0, 0, 0));
  EXPECT_EQ(c.apex, Vec3f(0, 0, 2));
  EXPECT_EQ(c.radius, 0.5f);
}

TEST(Nff, different_radii_give_an_outward_mesh) {
  const Scene scene = nff_scene("c 1 0 0 2 1 0 3 1");
  const Mesh& mesh = shape<Mesh>(scene, 0);
  ASSERT_EQ(mesh.triangles.size(), 2u * nff::kConeSides);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3f p = mesh.positions[i] - Vec3f(1, 0, 0);
    const float radius = 2.0f - p.z / 3.0f;
    EXPECT_NEAR(std::hypot(p.x, p.y), radius, 1e-6f);  // rounding of floats of about 3
    // The radius decreases by 1 over a height of 3, so the normal is (3 out + 1 up) / sqrt(10).
    const Vec3f out = Vec3f(p.x, p.y, 0.0f) / radius, expected = (3.0f * out + Vec3f(0, 0, 1)) / std::sqrt(10.0f);
    EXPECT_NEAR(glm::distance(mesh.normals[i], expected), 0.0f, 1e-6f);
  }
  for (const auto& t : mesh.triangles) {
    const Vec3f facet = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
    EXPECT_GT(glm::dot(facet, mesh.normals[t[0]]), 0.0f);
  }
}

TEST(Nff, pointed_cone_has_one_triangle_a_side) {
  EXPECT_EQ(shape<Mesh>(nff_scene("c 0 0 0 1 0 0 1 0"), 0).triangles.size(), 1u * nff::kConeSides);
}

TEST(Nff, polygon_is_faceted_and_patch_smooth) {
  const Scene scene = nff_scene("p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\npp 3\n0 0 0 0 0 2\n1 0 0 0 3 4\n0 1 0 0 0 0");
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(shape<Mesh>(scene, 0).triangles.size(), 2u);
  EXPECT_TRUE(shape<Mesh>(scene, 0).normals.empty());
  const Mesh& patch = shape<Mesh>(scene, 1);
  ASSERT_EQ(patch.normals.size(), 3u);
  EXPECT_EQ(patch.normals[0], Vec3f(0, 0, 1));
  EXPECT_EQ(patch.normals[1], Vec3f(0, 0.6f, 0.8f));
  EXPECT_EQ(patch.normals[2], Vec3f(0, 0, 1));  // the file's normal is zero, so the facet's normal replaces it
}

TEST(Nff, patch_is_flipped_to_match_normals) {
  const Scene scene = nff_scene("pp 3  0 0 0 0 0 -1  1 0 0 0 0 -1  0 1 0 0 0 -1\n");
  EXPECT_EQ(shape<Mesh>(scene, 0).triangles.at(0), (std::array<std::uint32_t, 3>{0, 2, 1}));
}

TEST(Nff, lights_share_their_intensity) {
  const Scene scene = nff_scene("l 1 2 3\nl 4 5 6 0.5 0.25 1 # comment\nl 0 0 0\nl 0 0 1\ns 0 0 0 1");
  ASSERT_EQ(scene.lights.size(), 4u);
  EXPECT_EQ(scene.lights[0].color, Vec3f(0.5f));  // the file states no colour, so it is 1 / sqrt(number of lights)
  EXPECT_EQ(scene.lights[1].color, Vec3f(0.5f, 0.25f, 1.0f));
  EXPECT_FALSE(scene.lights[0].inverse_square);
  EXPECT_EQ(evaluate(scene, 0.0).of(scene.lights[1].node).translation, Vec3f(4, 5, 6));
}

TEST(Nff, view_looks_from_one_point_at_another) {
  const Scene scene = nff_scene("v\nfrom 0 -10 0\nat 0 0 0\nup 0 0 1\nangle 90\nhither 1\nresolution 300 200\nb 0.1 0.2 0.3");
  ASSERT_EQ(scene.cameras.size(), 1u);
  const Affine3f world_from_camera = evaluate(scene, 0.0).of(scene.cameras[0].node);
  EXPECT_EQ(world_from_camera.translation, Vec3f(0, -10, 0));
  const auto near = [](Vec3f a, Vec3f b) { return glm::distance(a, b) < 1e-6f; };  // rounding of a quaternion
  EXPECT_TRUE(near(transform_vector(world_from_camera, {0, 0, -1}), {0, 1, 0}));
  EXPECT_TRUE(near(transform_vector(world_from_camera, {0, 1, 0}), {0, 0, 1}));
  EXPECT_TRUE(near(transform_vector(world_from_camera, {1, 0, 0}), {1, 0, 0}));
  EXPECT_FLOAT_EQ(scene.cameras[0].vertical_fov, kPi / 2);
  EXPECT_FLOAT_EQ(scene.cameras[0].aspect, 1.5f);
  EXPECT_FLOAT_EQ(scene.cameras[0].focus_distance, 10.0f);
  EXPECT_EQ(scene.resolution, Vec2i(300, 200));
  EXPECT_EQ(scene.background.horizon, Vec3f(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(scene.background.zenith, scene.background.horizon);
}

TEST(Nff, errors_name_line_and_accepted_values) {
  EXPECT_THAT(nff_error("s 0 0 0 1\nt 1 2 3"), AllOf(HasSubstr("a.nff:2: 't'"), HasSubstr("pp (patch)")));
  EXPECT_THAT(nff_error("s 0 0 nan 1"), HasSubstr("a.nff:1: expected a number for s, found 'nan'"));
  EXPECT_THAT(nff_error("s 0 0 1e30 1"), HasSubstr("a.nff:1:"));
  EXPECT_THAT(nff_error("s 0 0\n"), HasSubstr("the file ends, expected"));
  EXPECT_THAT(nff_error("\np 2\n0 0 0\n1 1 1"), HasSubstr("a.nff:2: 2 is out of range for p"));
  EXPECT_THAT(nff_error("p 1000000000\n0 0 0\n1 1 1"), HasSubstr("the file ends, expected"));
  EXPECT_THAT(nff_error("f 1 1 1 1 0 1 1.5 1"), HasSubstr("f's T is 1.5"));
  EXPECT_THAT(nff_error("c 0 0 0 1 0 0 1 -1"), HasSubstr("have different signs"));
}

TEST(Nff, view_must_be_complete_and_look_somewhere) {
  EXPECT_THAT(nff_error("v from 0 0 0 at 0 0 1 angle 45"), HasSubstr("not complete"));
  EXPECT_THAT(nff_error("v from 0 0 0 at 0 0 0 up 0 1 0 angle 45"), HasSubstr("span"));
  EXPECT_THAT(nff_error("v from 0 0 0 at 0 1 0 up 0 2 0 angle 45"), HasSubstr("span"));
  EXPECT_THAT(nff_error("v from 0 0 0 at 0 0 1 up 0 1 0 angle 180"), HasSubstr("angle is 180"));
}

TEST(Nff, shapes_without_extent_give_one_warning) {
  std::vector<std::string> warnings;
  Context context;
  context.warn = [&](std::string_view text) { warnings.emplace_back(text); };
  const Scene scene = parse_nff("a.nff", "s 0 0 0 0\nc 0 0 0 1 0 0 0 1\np 3 0 0 0 1 0 0 2 0 0", context);
  EXPECT_TRUE(scene.instances.empty());
  EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("3 shapes without extent")));
}

TEST(Nff, file_is_found_by_its_extension) {
  const test::TempDir dir;
  std::ofstream(dir / "balls.NFF") << "s 0 0 0 1\n";
  LoadOptions options;
  options.frames_per_second = 30.0;
  const Scene scene = load_scene((dir / "balls.NFF").string(), options, Context{});
  EXPECT_EQ(scene.name, "balls");
  EXPECT_EQ(scene.timeline.frames_per_second, 30.0);
  EXPECT_TRUE(scene.cameras.empty());
}

}  // namespace
}  // namespace lippmann
