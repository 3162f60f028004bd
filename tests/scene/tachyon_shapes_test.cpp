#include "tachyon_support.hpp"

namespace lippmann {
namespace {

using test::only_shape;
using test::Tachyon;
using test::xyz;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Triangle = std::array<std::uint32_t, 3>;

TEST_F(Tachyon, sphere_is_mirrored) {
  const Scene scene = files.load_statements("SPHERE CENTER 1 2 3 RAD 0.5" + white);
  const Spheres& spheres = only_shape<Spheres>(scene);
  ASSERT_EQ(spheres.size(), 1u);
  EXPECT_EQ(xyz(spheres[0].center), (std::array{1.0f, 2.0f, -3.0f}));
  EXPECT_EQ(spheres[0].radius, 0.5f);
}

TEST_F(Tachyon, keywords_in_any_case_are_read) {
  const Scene scene = files.load_statements("Sphere center 1 2 3 Rad 0.5" + white);
  EXPECT_EQ(only_shape<Spheres>(scene).size(), 1u);
}

TEST_F(Tachyon, plane_normal_becomes_a_unit_vector) {
  const Scene scene = files.load_statements("PLANE CENTER 1 2 3 NORMAL 0 3 4" + white);
  const Planes& planes = only_shape<Planes>(scene);
  EXPECT_EQ(xyz(planes[0].point), (std::array{1.0f, 2.0f, -3.0f}));
  EXPECT_EQ(xyz(planes[0].normal), (std::array{0.0f, 0.6f, -0.8f}));
}

TEST_F(Tachyon, tiny_normal_keeps_its_direction) {
  const Scene scene = files.load_statements("PLANE CENTER 0 0 0 NORMAL 0 3e-30 4e-30" + white);
  const Vec3f normal = only_shape<Planes>(scene)[0].normal;
  EXPECT_NEAR(normal.y, 0.6f, 1e-6f);  // numbers are rounded to floats
  EXPECT_NEAR(normal.z, -0.8f, 1e-6f);
}

TEST_F(Tachyon, ring_has_its_radii) {
  const Scene scene = files.load_statements("RING CENTER 1 2 3 NORMAL 0 0 2 INNER 0.5 OUTER 1.5" + white);
  const Rings& rings = only_shape<Rings>(scene);
  EXPECT_EQ(xyz(rings[0].center), (std::array{1.0f, 2.0f, -3.0f}));
  EXPECT_EQ(xyz(rings[0].normal), (std::array{0.0f, 0.0f, -1.0f}));
  EXPECT_EQ(rings[0].inner_radius, 0.5f);
  EXPECT_EQ(rings[0].outer_radius, 1.5f);
}

TEST_F(Tachyon, box_corners_are_ordered_after_mirroring) {
  const Scene scene = files.load_statements("BOX MIN -1 -2 -3 MAX 4 5 6" + white);
  const Boxes& boxes = only_shape<Boxes>(scene);
  EXPECT_EQ(xyz(boxes[0].lower), (std::array{-1.0f, -2.0f, -6.0f}));
  EXPECT_EQ(xyz(boxes[0].upper), (std::array{4.0f, 5.0f, 3.0f}));
}

TEST_F(Tachyon, swapped_box_corners_are_equal) {
  const Scene scene = files.load_statements("BOX MIN 4 -2 6 MAX -1 5 -3" + white);
  EXPECT_EQ(xyz(only_shape<Boxes>(scene)[0].lower), (std::array{-1.0f, -2.0f, -6.0f}));
}

TEST_F(Tachyon, fcylinder_runs_from_base_to_apex) {
  const Scene scene = files.load_statements("FCYLINDER BASE 1 2 3 APEX 4 5 6 RAD 0.25" + white);
  const Cylinders& cylinders = only_shape<Cylinders>(scene);
  EXPECT_EQ(xyz(cylinders[0].base), (std::array{1.0f, 2.0f, -3.0f}));
  EXPECT_EQ(xyz(cylinders[0].apex), (std::array{4.0f, 5.0f, -6.0f}));
  EXPECT_EQ(cylinders[0].radius, 0.25f);
}

TEST_F(Tachyon, polycylinder_has_spheres_and_cylinders) {
  const Scene scene = files.load_statements("POLYCYLINDER POINTS 3 0 0 0 1 0 0 1 1 0 RAD 0.25" + white);
  ASSERT_EQ(scene.shapes.size(), 2u);
  const Spheres& spheres = std::get<Spheres>(scene.shapes[0]);
  const Cylinders& cylinders = std::get<Cylinders>(scene.shapes[1]);
  ASSERT_EQ(spheres.size(), 3u);
  ASSERT_EQ(cylinders.size(), 2u);
  EXPECT_EQ(xyz(spheres[2].center), (std::array{1.0f, 1.0f, 0.0f}));
  EXPECT_EQ(xyz(cylinders[1].base), (std::array{1.0f, 0.0f, 0.0f}));
  EXPECT_EQ(xyz(cylinders[1].apex), (std::array{1.0f, 1.0f, 0.0f}));
}

/// In the file, V1 - V0 = x and V2 - V0 = y, so the normal (V1 - V0) x (V2 - V0) is +z. Mirroring turns it to -z.
TEST_F(Tachyon, triangle_keeps_its_normal_s_side) {
  const Scene scene = files.load_statements("TRI V0 0 0 1 V1 1 0 1 V2 0 1 1" + white);
  const Mesh& mesh = only_shape<Mesh>(scene);
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_TRUE(mesh.normals.empty());
  const auto [a, b, c] = mesh.triangles[0];
  const Vec3f normal = glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
  EXPECT_EQ(xyz(normal), (std::array{0.0f, 0.0f, -1.0f}));
  EXPECT_EQ(xyz(mesh.positions[a]), (std::array{0.0f, 0.0f, -1.0f}));
}

TEST_F(Tachyon, smooth_triangle_has_mirrored_normals) {
  const Scene scene = files.load_statements("STRI V0 0 0 1 V1 1 0 1 V2 0 1 1 N0 0 0 2 N1 3 0 4 N2 0 -3 4" + white);
  const Mesh& mesh = only_shape<Mesh>(scene);
  ASSERT_EQ(mesh.normals.size(), 3u);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 2, 1}));
  EXPECT_EQ(xyz(mesh.positions[1]), (std::array{1.0f, 0.0f, -1.0f}));
  EXPECT_EQ(xyz(mesh.normals[0]), (std::array{0.0f, 0.0f, -1.0f}));
  EXPECT_EQ(xyz(mesh.normals[1]), (std::array{0.6f, 0.0f, -0.8f}));
  EXPECT_EQ(xyz(mesh.normals[2]), (std::array{0.0f, -0.6f, -0.8f}));
}

TEST_F(Tachyon, zero_normal_becomes_facet_normal) {
  const Scene scene = files.load_statements("STRI V0 0 0 1 V1 1 0 1 V2 0 1 1 N0 0 0 0 N1 0 0 1 N2 0 0 1" + white);
  EXPECT_EQ(xyz(only_shape<Mesh>(scene).normals[0]), (std::array{0.0f, 0.0f, -1.0f}));
}

TEST_F(Tachyon, groups_shapes_by_material_and_kind) {
  const Scene scene = files.load_statements(
      "TEXDEF a AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR 1 0 0 TEXFUNC 0\n"
      "TEXDEF b AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR 0 1 0 TEXFUNC 0\n"
      "SPHERE CENTER 0 0 0 RAD 1 a SPHERE CENTER 0 0 0 RAD 2 b SPHERE CENTER 0 0 0 RAD 3 a\n"
      "TRI V0 0 0 0 V1 1 0 0 V2 0 1 0 a");
  ASSERT_EQ(scene.instances.size(), 3u);
  EXPECT_EQ(scene.instances[0].name, "a triangles");
  EXPECT_EQ(scene.instances[1].name, "a spheres");
  EXPECT_EQ(scene.instances[2].name, "b spheres");
  EXPECT_EQ(std::get<Spheres>(scene.shapes[1]).size(), 2u);
  EXPECT_EQ(scene.instances[1].material, 0);
  EXPECT_EQ(scene.instances[2].material, 1);
  EXPECT_EQ(scene.instances[2].node, -1);
}

TEST_F(Tachyon, empty_shapes_give_one_warning) {
  const Scene scene = files.load_statements(
      "SPHERE CENTER 0 0 0 RAD 0" + white + "FCYLINDER BASE 1 1 1 APEX 1 1 1 RAD 1" + white +
      "FCYLINDER BASE 0 1 1 APEX 1 1 1 RAD 0" + white + "RING CENTER 0 0 0 NORMAL 0 0 1 INNER 2 OUTER 2" + white +
      "TRI V0 0 0 0 V1 1 1 1 V2 2 2 2" + white + "STRI V0 1 0 0 V1 1 0 0 V2 0 1 0 N0 0 0 1 N1 0 0 1 N2 0 0 1" + white);
  EXPECT_TRUE(scene.shapes.empty());
  EXPECT_THAT(files.warnings, ElementsAre("scene.dat: 6 shapes without extent are left out."));
}

const std::string kQuad =
    "VERTEXARRAY NUMVERTS 4 COORDS 0 0 0 1 0 0 0 1 0 1 1 0 NORMALS 0 0 1 0 0 1 0 0 2 0 0 1 TEXTURE AMBIENT 0 DIFFUSE 1 "
    "SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 0 ";

TEST_F(Tachyon, trimesh_shares_vertices) {
  const Scene scene = files.load_statements(kQuad + "TRIMESH 2 0 1 2 2 1 3 END_VERTEXARRAY");
  const Mesh& mesh = only_shape<Mesh>(scene);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 2, 1}, Triangle{2, 3, 1}));
  EXPECT_EQ(xyz(mesh.normals[2]), (std::array{0.0f, 0.0f, -1.0f}));
}

TEST_F(Tachyon, tristrip_turns_every_second_triangle_over) {
  const Scene scene = files.load_statements(kQuad + "TRISTRIP 4 0 1 2 3 END_VERTEXARRAY");
  const Mesh& mesh = only_shape<Mesh>(scene);
  // Tachyon's triangles are 0 1 2 and 2 1 3. Mirroring swaps their second and third corner.
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 2, 1}, Triangle{2, 3, 1}));
}

TEST_F(Tachyon, vertexarray_without_texture_is_matt_white) {
  const Scene scene = files.load_statements(
      "VERTEXARRAY NUMVERTS 3 COORDS 0 0 0 1 0 0 0 1 0 NORMALS 0 0 1 0 0 1 0 0 1 TRIMESH 1 0 1 2 END_VERTEXARRAY");
  const PhongSurface& surface = test::phong(scene.materials[0]);
  EXPECT_EQ(xyz(surface.color), (std::array{1.0f, 1.0f, 1.0f}));
  EXPECT_EQ(surface.ambient, 0.1f);
  EXPECT_EQ(surface.diffuse, 0.9f);
}

TEST_F(Tachyon, vertexarray_with_two_textures_is_two_meshes) {
  const Scene scene =
      files.load_statements(kQuad +
                            "TRIMESH 1 0 1 2 TEXTURE AMBIENT 1 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR 1 0 0 TEXFUNC 0 "
                            "TRIMESH 1 2 1 3 END_VERTEXARRAY");
  ASSERT_EQ(scene.shapes.size(), 2u);
  const Mesh& second = std::get<Mesh>(scene.shapes[1]);
  EXPECT_EQ(second.positions.size(), 3u);
  EXPECT_EQ(xyz(second.positions[2]), (std::array{1.0f, 1.0f, 0.0f}));
}

TEST_F(Tachyon, vertex_colours_make_the_material_white) {
  const Scene scene = files.load_statements(
      "VERTEXARRAY NUMVERTS 3 COORDS 0 0 0 1 0 0 0 1 0 NORMALS 0 0 1 0 0 1 0 0 0 COLORS 1 0 0 0 1 0 0 0 1 TEXTURE AMBIENT 0.3 "
      "DIFFUSE 1 "
      "SPECULAR 0 OPACITY 1 COLOR 0.5 0.5 0.5 TEXFUNC 0 TRIMESH 1 0 1 2 END_VERTEXARRAY");
  const Mesh& mesh = only_shape<Mesh>(scene);
  ASSERT_EQ(mesh.colors.size(), 3u);
  EXPECT_EQ(xyz(mesh.colors[1]), (std::array{0.0f, 1.0f, 0.0f}));
  const PhongSurface& surface = test::phong(scene.materials[static_cast<std::size_t>(scene.instances[0].material)]);
  EXPECT_EQ(xyz(surface.color), (std::array{1.0f, 1.0f, 1.0f}));
  EXPECT_EQ(surface.ambient, 0.3f);
}

TEST_F(Tachyon, vertex_colours_count_from_where_they_stand) {
  const Scene scene =
      files.load_statements(kQuad + "TRIMESH 1 0 1 2 COLORS 1 0 0 0 1 0 0 0 1 1 1 1 TRIMESH 1 0 1 2 END_VERTEXARRAY");
  ASSERT_EQ(scene.shapes.size(), 2u);
  EXPECT_TRUE(std::get<Mesh>(scene.shapes[0]).colors.empty());
  EXPECT_EQ(std::get<Mesh>(scene.shapes[1]).colors.size(), 3u);
}

TEST_F(Tachyon, vcstri_has_colours_and_no_texture) {
  const Scene scene = files.load_statements(
      "VCSTRI V0 0 0 1 V1 1 0 1 V2 0 1 1 N0 0 0 1 N1 0 0 1 N2 0 0 1 C0 1 0 0 C1 0 1 0 C2 0 0 1 "
      "AMBIENT 0.3 DIFFUSE 0.6 SPECULAR 0 OPACITY 0.5 PHONG PLASTIC 0.5 PHONG_SIZE 40 VCST");
  const Mesh& mesh = only_shape<Mesh>(scene);
  ASSERT_EQ(mesh.colors.size(), 3u);
  EXPECT_EQ(xyz(mesh.colors[2]), (std::array{0.0f, 0.0f, 1.0f}));
  EXPECT_EQ(xyz(mesh.positions[2]), (std::array{0.0f, 1.0f, -1.0f}));
  EXPECT_EQ(test::phong(scene.materials[0]).highlight_size, 40.0f);
}

/// With two grid points per side, the landscape is its four corners. Heights are Tachyon's random numbers: x <-
/// 1099087573 x mod 2^32, starting from x = 4, divided by 2^32.
TEST_F(Tachyon, smallest_landscape_has_two_triangles) {
  const Scene scene = files.load_statements("SCAPE RES 2 2 SCALE 4 6 CENTER 1 2 3" + white);
  const Mesh& mesh = only_shape<Mesh>(scene);
  ASSERT_EQ(mesh.positions.size(), 4u);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  std::uint32_t x = 4;
  std::vector<float> heights;
  for (int i = 0; i < 4; ++i) heights.push_back(2.0f + static_cast<float>((x *= 1099087573u) / 4294967296.0));
  // The mesh stores grid points in the order in which its triangles use them: (0, 0), (1, 1), (1, 0), (0, 1).
  EXPECT_EQ(xyz(mesh.positions[0]), (std::array{-1.0f, heights[0], 0.0f}));
  EXPECT_EQ(xyz(mesh.positions[1]), (std::array{3.0f, heights[3], -6.0f}));
  EXPECT_EQ(xyz(mesh.positions[2]), (std::array{3.0f, heights[1], 0.0f}));
  EXPECT_EQ(xyz(mesh.positions[3]), (std::array{-1.0f, heights[2], -6.0f}));
  EXPECT_EQ(xyz(mesh.normals[0]), (std::array{0.0f, 1.0f, 0.0f}));
}

TEST_F(Tachyon, landscape_is_never_below_its_center) {
  const Scene scene = files.load_statements("SCAPE RES 40 30 SCALE 80 60 CENTER 0 -4 0" + white);
  const Mesh& mesh = only_shape<Mesh>(scene);
  EXPECT_EQ(mesh.triangles.size(), 2u * 39 * 29);
  for (const Vec3f p : mesh.positions) EXPECT_GE(p.y, -4.0f);
}

TEST_F(Tachyon, tpolyfile_scales_rotates_and_moves) {
  files.write("models/a.tpoly", "3\n1 0 0\n0 1 0\n0 0 1\n");
  // Each corner is scaled by 2, rotated by 90 degrees about z, which turns (x, y) to (-y, x), and moved by 10 in x.
  const Scene scene = files.load_statements("TPOLYFILE SCALE 2 2 2 ROT 0 0 90 CENTER 10 0 0 FILE models/a.tpoly" + white);
  const Mesh& mesh = only_shape<Mesh>(scene);
  ASSERT_EQ(mesh.positions.size(), 3u);
  // The second corner comes first, as in Tachyon. z is mirrored.
  const Vec3f expected[] = {{8, 0, 0}, {10, 2, 0}, {10, 0, -2}};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(glm::length(mesh.positions[i] - expected[i]), 1e-6f) << i;  // rounding
}

/// Tachyon's rotation about y has +sin in its third row, where a proper rotation has -sin. It turns (1, 0, 0) to (cos,
/// 0, +sin).
TEST_F(Tachyon, tpolyfile_turns_about_y_as_tachyon_does) {
  files.write("a.tpoly", "3 0 0 0 1 0 0 0 1 0");
  const Scene scene = files.load_statements("TPOLYFILE SCALE 1 1 1 ROT 0 30 0 CENTER 0 0 0 FILE a.tpoly" + white);
  const Vec3f corner = only_shape<Mesh>(scene).positions[0];
  EXPECT_NEAR(corner.x, std::sqrt(0.75f), 1e-6f);
  EXPECT_NEAR(corner.z, -0.5f, 1e-6f);  // z is mirrored
}

TEST_F(Tachyon, four_corner_tpolyfile_names_the_file) {
  files.write("a.tpoly", "3 0 0 0 1 0 0 0 1 0\n4 0 0 0 1 0 0 1 1 0 0 1 0");
  EXPECT_THAT(files.error_of_statements("TPOLYFILE SCALE 1 1 1 ROT 0 0 0 CENTER 0 0 0 FILE a.tpoly" + white),
              HasSubstr("a.tpoly:2: 4 is out of range for the number of a polygon's corners"));
}

TEST_F(Tachyon, truncated_tpolyfile_names_the_file) {
  files.write("a.tpoly", "3 0 0 0 1 0 0\n0 1");
  EXPECT_EQ(files.error_of_statements("TPOLYFILE SCALE 1 1 1 ROT 0 0 0 CENTER 0 0 0 FILE a.tpoly" + white),
            "a.tpoly:2: the file ends, expected a polygon's corners");
}

TEST_F(Tachyon, tpolyfile_out_of_range_is_an_error) {
  files.write("a.tpoly", "3 0 0 0 1e30 0 0 0 1 0");
  EXPECT_THAT(files.error_of_statements("TPOLYFILE SCALE 1e30 1 1 ROT 0 0 0 CENTER 0 0 0 FILE a.tpoly" + white),
              HasSubstr("a.tpoly:1: SCALE puts a corner out of range"));
}

TEST_F(Tachyon, include_continues_where_it_was) {
  files.write("parts/ball.inc", "SPHERE CENTER 1 0 0 RAD 1 a\n# no END_SCENE here\n");
  const Scene scene = files.load_statements(
      "TEXDEF a AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR 1 0 0 TEXFUNC 0 INCLUDE parts/ball.inc SPHERE CENTER 2 0 0 RAD "
      "1 a");
  EXPECT_EQ(only_shape<Spheres>(scene).size(), 2u);
}

TEST_F(Tachyon, include_error_names_the_file) {
  files.write("a.inc", "\nSPHERE CENTER x");
  EXPECT_THAT(files.error_of_statements("INCLUDE a.inc"), testing::StartsWith("a.inc:2: expected a number for"));
}

TEST_F(Tachyon, include_of_itself_is_an_error) {
  files.write("a.inc", "INCLUDE a.inc");
  EXPECT_THAT(files.error_of_statements("INCLUDE a.inc"), HasSubstr("a.inc:1: INCLUDE 'a.inc' exceeds a limit"));
}

TEST_F(Tachyon, includes_that_multiply_are_an_error) {
  std::string forty;
  for (int i = 0; i < 40; ++i) forty += "INCLUDE b.inc ";
  files.write("a.inc", forty);
  files.write("b.inc", "# nothing");
  std::string many;
  for (int i = 0; i < 40; ++i) many += "INCLUDE a.inc ";
  EXPECT_THAT(files.error_of_statements(many), HasSubstr("exceeds a limit"));
}

}  // namespace
}  // namespace lippmann
