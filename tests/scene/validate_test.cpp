#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Scene good_scene() {
  Scene scene;
  scene.nodes.resize(3);
  scene.nodes[1].parent = 0;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 1, 2}};
  mesh.skin = {1, {0, 1, 1}, {1, 1, 1}};
  mesh.targets.resize(1);
  scene.nodes[0].morph_weights = {0.5f};
  scene.skins = {{"", {0, 1}, {Affine3f{}, Affine3f{}}}};
  scene.shapes = {mesh, Spheres(1), Cylinders(1), Planes(1), Rings(1), Boxes(1)};
  Texture texture;
  texture.width = 2, texture.height = 1, texture.rgba.resize(8);
  scene.textures = {texture};
  PhongSurface phong;
  phong.texture = 0;
  phong.projection = ImageProjection{};
  MetallicRoughness metal;
  metal.base_color_map.texture = 0;
  scene.materials = {{"p", phong}, {"m", metal}};
  for (int i = 0; i < 6; ++i) scene.instances.push_back({"", i, i % 2, i % 3});
  scene.instances[0].skin = 0;
  scene.lights.resize(1);
  scene.cameras.resize(1);
  scene.display = DisplayPlacement{};
  NodeAnimation animation;
  animation.node = 1;
  animation.translation = {{0.0, 1.0}, {{0, 0, 0}, {1, 0, 0}}, Interpolation::kLinear};
  scene.timeline.animations = {animation};
  return scene;
}

Mesh& mesh_of(Scene& s) { return std::get<Mesh>(s.shapes[0]); }
PhongSurface& phong_of(Scene& s) { return std::get<PhongSurface>(s.materials[0].surface); }
MetallicRoughness& metal_of(Scene& s) { return std::get<MetallicRoughness>(s.materials[1].surface); }
NodeAnimation& animation_of(Scene& s) { return s.timeline.animations[0]; }

TEST(Validate, good_scene_passes) { EXPECT_NO_THROW(validate(good_scene(), "a.dat")); }

struct Fault {
  const char* name;
  std::function<void(Scene&)> spoil;
  const char* message;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class ValidateFault : public testing::TestWithParam<Fault> {};

TEST_P(ValidateFault, invalid_scene_names_file_and_element) {
  Scene scene = good_scene();
  GetParam().spoil(scene);
  try {
    validate(scene, "a.dat");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "a.dat");
    EXPECT_THAT(error.problem(), testing::HasSubstr(GetParam().message));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ValidateFault,
    testing::Values(
        Fault{"vertex_nan", [](Scene& s) { mesh_of(s).positions[1].y = kNan; }, "shape 0: the position of vertex 1"},
        Fault{"vertex_inf", [](Scene& s) { mesh_of(s).positions[2].z = kInfinity; }, "vertex 2"},
        Fault{"normal_count", [](Scene& s) { mesh_of(s).normals.pop_back(); }, "needs one normal per vertex"},
        Fault{"normal_zero", [](Scene& s) { mesh_of(s).normals[0] = Vec3f(0.0f); }, "the normal of vertex 0"},
        Fault{"uv_count", [](Scene& s) { mesh_of(s).uvs.pop_back(); }, "needs one uv per vertex"},
        Fault{"color_count", [](Scene& s) { mesh_of(s).colors.resize(2); }, "needs one colour per vertex"},
        Fault{"color_nan", [](Scene& s) { mesh_of(s).colors.assign(3, Vec3f(kNan)); }, "the colour of vertex 0"},
        Fault{"second_uv_count", [](Scene& s) { mesh_of(s).uvs_1.resize(2); }, "needs one second uv per vertex"},
        Fault{"alpha_nan", [](Scene& s) { mesh_of(s).alphas = {1, 1, kNan}; }, "the alpha of vertex 2"},
        Fault{"tangent_length", [](Scene& s) { mesh_of(s).tangents.assign(3, Vec4f(1)); }, "the tangent of vertex 0"},
        Fault{"target_count", [](Scene& s) { mesh_of(s).targets[0].positions.resize(2); }, "needs one morphed position"},
        Fault{"target_nan", [](Scene& s) { mesh_of(s).targets[0].normals.assign(3, Vec3f(kNan)); }, "morphed normal of vertex"},
        Fault{"skin_weights_count", [](Scene& s) { mesh_of(s).skin.weights.pop_back(); }, "does not match the vertices"},
        Fault{"skin_weight_nan", [](Scene& s) { mesh_of(s).skin.weights[1] = kNan; }, "a weight is not a number"},
        Fault{"skin_weight_sum", [](Scene& s) { mesh_of(s).skin.weights[0] += 0.5f; }, "weights of vertex 0 sum to"},
        Fault{"skin_weight_joint", [](Scene& s) { mesh_of(s).skin.joints[2] = 2; }, "refers to joint 2, but the number of joints is 2"},
        Fault{"skin_joint", [](Scene& s) { s.skins[0].joints[1] = 3; }, "skin 0: node 3"},
        Fault{"skin_matrices", [](Scene& s) { s.skins[0].joint_from_mesh.pop_back(); }, "needs one matrix per joint"},
        Fault{"skin_matrix_nan", [](Scene& s) { s.skins[0].joint_from_mesh[0].translation.x = kNan; }, "matrix is not finite"},
        Fault{"instance_skin", [](Scene& s) { s.instances[0].skin = 1; }, "instance 0: skin 1"},
        Fault{"skin_without_weights", [](Scene& s) { s.instances[1].skin = 0; }, "its mesh has no weights"},
        Fault{"morph_weight_count", [](Scene& s) { s.nodes[0].morph_weights.clear(); }, "1 morph targets, but its node has 0 weights"},
        Fault{"morph_weight_nan", [](Scene& s) { s.nodes[0].morph_weights[0] = kNan; }, "morph weight is not finite"},
        Fault{"map_texture", [](Scene& s) { metal_of(s).clearcoat_normal_map.texture = 1; }, "material 1 (m): texture 1"},
        Fault{"map_set", [](Scene& s) { metal_of(s).normal_map.uv_set = 2; }, "uv set is not 0 or 1"},
        Fault{"map_transform", [](Scene& s) { metal_of(s).emissive_map.matrix[1].x = kNan; }, "transform is not finite"},
        Fault{"specular_nan", [](Scene& s) { metal_of(s).specular = kNan; }, "coefficient"},
        Fault{"uv_nan", [](Scene& s) { mesh_of(s).uvs[0].x = kNan; }, "the uv of vertex 0"},
        Fault{"triangle_index", [](Scene& s) { mesh_of(s).triangles[0][1] = 3; }, "triangle 0 refers to vertex 3, but the number of vertices is 3"},
        Fault{"sphere_radius", [](Scene& s) { std::get<Spheres>(s.shapes[1])[0].radius = 0.0f; }, "shape 1, element 0"},
        Fault{"sphere_center", [](Scene& s) { std::get<Spheres>(s.shapes[1])[0].center.x = kNan; }, "center is not finite"},
        Fault{"cylinder_radius", [](Scene& s) { std::get<Cylinders>(s.shapes[2])[0].radius = -1.0f; }, "cylinder's radius"},
        Fault{"cylinder_length", [](Scene& s) { std::get<Cylinders>(s.shapes[2])[0].apex = Vec3f(0.0f); }, "no length"},
        Fault{"plane_normal", [](Scene& s) { std::get<Planes>(s.shapes[3])[0].normal *= 2.0f; }, "plane's normal"},
        Fault{"ring_radii", [](Scene& s) { std::get<Rings>(s.shapes[4])[0].inner_radius = 1.0f; }, "ring's radii"},
        Fault{"ring_nan", [](Scene& s) { std::get<Rings>(s.shapes[4])[0].inner_radius = kNan; }, "ring's radii"},
        Fault{"box_corners", [](Scene& s) { std::get<Boxes>(s.shapes[5])[0].upper.x = -2.0f; }, "lower corner"},
        Fault{"texture_empty", [](Scene& s) { s.textures[0].width = 0; }, "texture 0: has no pixels"},
        Fault{"texture_bytes", [](Scene& s) { s.textures[0].rgba.pop_back(); }, "four bytes per pixel"},
        Fault{"material_texture", [](Scene& s) { phong_of(s).texture = 1; }, "material 0 (p): texture 1 is out of range"},
        Fault{"material_nan", [](Scene& s) { phong_of(s).opacity = kNan; }, "coefficient"},
        Fault{"material_mapping", [](Scene& s) { phong_of(s).projection->scale.y = kNan; }, "projection is not finite"},
        Fault{"material_ior", [](Scene& s) { metal_of(s).ior = 0.0f; }, "refraction"},
        Fault{"material_color", [](Scene& s) { metal_of(s).base_color.w = kInfinity; }, "colour"},
        Fault{"instance_shape", [](Scene& s) { s.instances[0].shape = -1; }, "instance 0: shape -1"},
        Fault{"instance_material", [](Scene& s) { s.instances[0].material = 2; }, "material 2"},
        Fault{"instance_node", [](Scene& s) { s.instances[0].node = 3; }, "node 3"},
        Fault{"node_parent", [](Scene& s) { s.nodes[1].parent = 1; }, "node 1: parent 1"},
        Fault{"node_scale", [](Scene& s) { s.nodes[0].local.scale.x = kNan; }, "transform"},
        Fault{"node_rotation", [](Scene& s) { s.nodes[0].local.rotation = Quatf(0, 0, 0, 0); }, "unit quaternion"},
        Fault{"uneven_scale", [](Scene& s) { s.nodes[0].local.scale.x = 2.0f; }, "scales an analytic shape non-uniformly"},
        Fault{"uneven_matrix",
              [](Scene& s) {
                s.nodes[0].matrix = Affine3f{Mat3f(1, 0, 0, 1, 1, 0, 0, 0, 1), Vec3f(0)};
              },
              "non-uniformly"},
        Fault{"uneven_animation",
              [](Scene& s) {
                animation_of(s).scale = {{0.0}, {{1, 2, 1}}, Interpolation::kStep};
              },
              "non-uniformly"},
        Fault{"light_node", [](Scene& s) { s.lights[0].node = 7; }, "light 0: node 7"},
        Fault{"light_color", [](Scene& s) { s.lights[0].color.x = kNan; }, "colour"},
        Fault{"light_attenuation", [](Scene& s) { s.lights[0].attenuation = Vec3f(0.0f); }, "attenuation"},
        Fault{"light_range", [](Scene& s) { s.lights[0].range = 0.0f; }, "range"},
        Fault{"light_cones", [](Scene& s) { s.lights[0].inner_cone = 1.0f; }, "cone angles"},
        Fault{"light_radius", [](Scene& s) { s.lights[0].visible_radius = -1.0f; }, "visible radius"},
        Fault{"light_size", [](Scene& s) { s.lights[0].radius = -1.0f; }, "the radius is not a number >= 0"},
        Fault{"light_size_without_fall_off", [](Scene& s) { s.lights[0].radius = 1.0f; }, "inverse-square falloff"},
        Fault{"light_angle", [](Scene& s) { s.lights[0].angular_diameter = 4.0f; }, "not between 0 and pi"},
        Fault{"light_angle_of_point", [](Scene& s) { s.lights[0].angular_diameter = 1.0f; }, "only directional lights"},
        Fault{"camera_height", [](Scene& s) { s.cameras[0].orthographic_height = -1.0f; }, "orthographic height"},
        Fault{"camera_near", [](Scene& s) { s.cameras[0].near_distance = -1.0f; }, "near distance"},
        Fault{"camera_shift", [](Scene& s) { s.cameras[0].shift.x = kInfinity; }, "shift"},
        Fault{"camera_fov", [](Scene& s) { s.cameras[0].vertical_fov = kPi; }, "camera 0: the field of view"},
        Fault{"origin", [](Scene& s) { s.origin.y = std::nan(""); }, "origin: is not finite"},
        Fault{"shown_animation", [](Scene& s) { s.animation = 0; }, "animation: animation 0 is out of range"},
        Fault{"node_parent_below_none", [](Scene& s) { s.nodes[1].parent = -2; }, "node 1: parent -2"},
        Fault{"node_cycle", [](Scene& s) { s.nodes[0].parent = 1; }, "node 0: parent 1"},
        Fault{"animated_node", [](Scene& s) { animation_of(s).node = 3; }, "animation 0: node 3"},
        Fault{"display_node", [](Scene& s) { s.display->node = 3; }, "display: node 3"},
        Fault{"light_web", [](Scene& s) { s.lights[0].web = 0; }, "photometric web does not exist"},
        Fault{"camera_node", [](Scene& s) { s.cameras[0].node = -2; }, "node -2"},
        Fault{"camera_offset", [](Scene& s) { s.cameras[0].pixel_offset.x = kNan; }, "pixel offset"},
        Fault{"display_height", [](Scene& s) { s.display->plane_height = 0.0f; }, "display: the height"},
        Fault{"display_distance", [](Scene& s) { s.display->viewing_distance = kNan; }, "viewing distance"},
        Fault{"panorama_width",
              [](Scene& s) { s.background.map.emplace().radiance = Image(EnvironmentMap::kMostWidth + 1, 1, 3); },
              "environment: has more than 32768 x 16384 pixels"},
        Fault{"background_heights", [](Scene& s) { s.background.horizon_at = 1.0f; }, "heights of horizon and zenith"},
        Fault{"projection_axes",
              [](Scene& s) {
                phong_of(s).projection->kind = ProjectionKind::kSphere;
                phong_of(s).projection->u_axis = Vec3f(0, 1, 0);
              },
              "not orthonormal"},
        Fault{"background_up", [](Scene& s) { s.background.up = Vec3f(0.0f); }, "background: up"},
        Fault{"depth", [](Scene& s) { s.max_depth = 0; }, "max_depth"},
        Fault{"frames", [](Scene& s) { s.timeline.frame_count = 0; }, "no frames"},
        Fault{"fps", [](Scene& s) { s.timeline.frames_per_second = 0.0; }, "frames per second"},
        Fault{"twice_animated", [](Scene& s) { s.timeline.animations.push_back(animation_of(s)); }, "node 1 is animated twice"},
        Fault{"animated_matrix", [](Scene& s) { s.nodes[1].matrix = Affine3f{}; }, "node with a matrix"},
        Fault{"key_count", [](Scene& s) { animation_of(s).translation.values.pop_back(); }, "needs 1 values per key"},
        Fault{"weight_keys", [](Scene& s) { animation_of(s).morph_weights = {{0.0}, {1.0f}}; }, "morph weights: needs 0 values"},
        Fault{"cubic_keys", [](Scene& s) { animation_of(s).translation.interpolation = Interpolation::kCubicSpline; }, "needs 3"},
        Fault{"key_times", [](Scene& s) { animation_of(s).translation.times[1] = 0.0; }, "do not increase"},
        Fault{"key_nan", [](Scene& s) { animation_of(s).translation.values[1].z = kNan; }, "a value is not finite"}),
    [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace
}  // namespace lippmann
