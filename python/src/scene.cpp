// Binds scenes. Elements are identified by index; lippmann.Scene adds names.
#include <algorithm>
#include <utility>
#include <variant>

#include "archive.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "interruptible.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/frames/frame_params.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/scene/builtin.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/scene/origin.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/stage/camera_set.hpp"
#include "lippmann/stage/choose_camera.hpp"
#include "lippmann/stage/environment_file.hpp"
#include "lippmann/stage/lighting.hpp"

namespace lippmann::python {
namespace {

using SharedScene = std::shared_ptr<Scene>;
using Three = std::array<float, 3>;
using Four = std::array<float, 4>;

Vec3f vec(const Three& v) { return {v[0], v[1], v[2]}; }
Quatf quaternion(const Four& xyzw) { return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]}; }

template <class T>
int add(std::vector<T>& elements, T element) {
  elements.push_back(std::move(element));
  return static_cast<int>(elements.size()) - 1;
}

SharedScene load(const std::string& name, const LoadOptions& options) {
  SharedScene scene;
  Interruptible(0).run(py::none(),
                       [&](const Context& context) { scene = std::make_shared<Scene>(load_scene(name, options, context)); });
  return scene;
}

int add_node(Scene& scene, std::string name, int parent, const std::array<double, 3>& translation, const Four& rotation,
             const Three& scale) {
  Node node;
  node.name = std::move(name);
  node.parent = parent;
  const Vec3d place(translation[0], translation[1], translation[2]);
  node.local = {Vec3f(parent < 0 ? place - scene.origin : place), quaternion(rotation), vec(scale)};
  return add(scene.nodes, std::move(node));
}

int add_mesh(Scene& scene, const Array<float>& positions, const Array<std::uint32_t>& triangles,
             const std::optional<Array<float>>& normals, const std::optional<Array<float>>& uvs,
             const std::optional<Array<float>>& colors) {
  Mesh mesh;
  mesh.positions = vectors_of<Vec3f>(positions, "positions");
  require_shape(triangles, {-1, 3}, "triangles");
  mesh.triangles.resize(static_cast<std::size_t>(triangles.shape(0)));
  const std::uint32_t* index = triangles.data();
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& vertex : triangle) vertex = *index++;
  if (normals) mesh.normals = vectors_of<Vec3f>(*normals, "normals");
  if (uvs) mesh.uvs = vectors_of<Vec2f>(*uvs, "uvs");
  if (colors) mesh.colors = vectors_of<Vec3f>(*colors, "colors");
  return add(scene.shapes, Shape(std::move(mesh)));
}

int add_texture(Scene& scene, const Array<std::uint8_t>& rgba, bool srgb) {
  require_shape(rgba, {-1, -1, 4}, "texture");
  Texture texture;
  texture.width = static_cast<int>(rgba.shape(1)), texture.height = static_cast<int>(rgba.shape(0));
  texture.rgba.assign(rgba.data(), rgba.data() + rgba.size());
  texture.srgb = srgb;
  return add(scene.textures, std::move(texture));
}

void bind_surface(py::module_& module) {
  py::class_<MetallicRoughness>(module, "Surface")
      .def(py::init())
      .def(pickled<MetallicRoughness>())
      .def("set_base_color",
           [](MetallicRoughness& surface, const Four& rgba, int texture) {
             surface.base_color = {rgba[0], rgba[1], rgba[2], rgba[3]};
             surface.base_color_map.texture = texture;
             surface.blend = rgba[3] < 1.0f;
           })
      .def("set_emissive", [](MetallicRoughness& surface, const Three& color) { surface.emissive = vec(color); })
      .def_readwrite("metallic", &MetallicRoughness::metallic)
      .def_readwrite("roughness", &MetallicRoughness::roughness)
      .def_readwrite("transmission", &MetallicRoughness::transmission)
      .def_readwrite("ior", &MetallicRoughness::ior)
      .def_readwrite("clearcoat", &MetallicRoughness::clearcoat)
      .def_readwrite("double_sided", &MetallicRoughness::double_sided)
      .def_readwrite("unlit", &MetallicRoughness::unlit);
}

Light light_of(std::string name, const std::string& kind, int node, const Three& color) {
  Light light;
  light.name = std::move(name);
  light.kind = kind == "directional" ? LightKind::kDirectional : kind == "spot" ? LightKind::kSpot : LightKind::kPoint;
  light.node = node;
  light.color = vec(color);
  light.inverse_square = light.kind != LightKind::kDirectional;
  return light;
}

/// Angles are in radians, lengths in scene units.
void bind_light(py::module_& module) {
  py::class_<Light>(module, "Light")
      .def(py::init(&light_of))
      .def(pickled<Light>())
      .def_readwrite("range", &Light::range)
      .def_readwrite("inner_cone", &Light::inner_cone)
      .def_readwrite("outer_cone", &Light::outer_cone)
      .def_readwrite("radius", &Light::radius)
      .def_readwrite("angular_diameter", &Light::angular_diameter);
}

int add_camera(Scene& scene, std::string name, int node, float vertical_fov, float aspect, float focus_distance) {
  Camera camera;
  camera.name = std::move(name);
  camera.node = node;
  camera.vertical_fov = vertical_fov, camera.aspect = aspect, camera.focus_distance = focus_distance;
  return add(scene.cameras, std::move(camera));
}

/// Returns the animation of a node. Adds an empty animation if the node has none.
NodeAnimation& animation_of(Scene& scene, int node) {
  for (NodeAnimation& animation : scene.timeline.animations)
    if (animation.node == node) return animation;
  scene.timeline.animations.emplace_back().node = node;
  return scene.timeline.animations.back();
}

template <class T>
Channel<T> channel_of(const Timeline& timeline, std::vector<T> values) {
  Channel<T> channel;
  for (std::size_t frame = 0; frame < values.size(); ++frame) channel.times.push_back(timeline.time(static_cast<int>(frame)));
  channel.values = std::move(values);
  return channel;
}

void animate(Scene& scene, int node, const std::optional<Array<float>>& translation,
             const std::optional<Array<float>>& rotation, const std::optional<Array<float>>& scale,
             const std::optional<Array<float>>& weights) {
  NodeAnimation& animation = animation_of(scene, node);
  if (translation) {
    animation.translation = channel_of(scene.timeline, vectors_of<Vec3f>(*translation, "translation"));
    if (scene.nodes.at(static_cast<std::size_t>(node)).parent < 0 && scene.origin != Vec3d(0.0))
      for (Vec3f& place : animation.translation.values) place = Vec3f(Vec3d(place) - scene.origin);
  }
  if (scale) animation.scale = channel_of(scene.timeline, vectors_of<Vec3f>(*scale, "scale"));
  if (weights) {
    animation.morph_weights = channel_of(scene.timeline, std::vector<float>(static_cast<std::size_t>(weights->shape(0))));
    animation.morph_weights.values.assign(weights->data(), weights->data() + weights->size());
  }
  if (!rotation) return;
  std::vector<Quatf> turns;
  for (const Vec4f& xyzw : vectors_of<Vec4f>(*rotation, "rotation")) turns.emplace_back(xyzw.w, xyzw.x, xyzw.y, xyzw.z);
  animation.rotation = channel_of(scene.timeline, std::move(turns));
}

template <class T>
std::vector<py::str> names_of(const std::vector<T>& elements) {
  std::vector<py::str> names;
  for (const T& element : elements) names.push_back(decoded(element.name));
  return names;
}

void surround_with_file(Scene& scene, const std::filesystem::path& path, float strength, float rotation_deg) {
  Interruptible(0).run(py::none(), [&](const Context& context) {
    scene.background.map = read_environment(path, strength, rotation_deg, context);
  });
}

/// Returns (2, 3): the lowest and the highest coordinates of all finite shapes, or None if there are none.
py::object bounds_of(const Scene& scene, int frame) {
  const Bounds3f bounds = finite_bounds(scene, evaluate(scene, scene.timeline.time(frame)));
  if (bounds.empty()) return py::none();
  std::vector<double> corners;
  for (const Vec3f corner : {bounds.lower, bounds.upper})
    for (int c = 0; c < 3; ++c) corners.push_back(scene.origin[c] + static_cast<double>(corner[c]));
  return moved(std::move(corners), {2, 3});
}

const char* word_for(SceneKind kind) {
  return kind == SceneKind::kSplats ? "splats" : kind == SceneKind::kWhitted ? "whitted" : "physical";
}

void bind_elements(py::class_<Scene, SharedScene>& scene) {
  scene.def("add_node", &add_node)
      .def("add_mesh", &add_mesh)
      .def("add_sphere",
           [](Scene& s, const Three& center, float radius) {
             return add(s.shapes, Shape(Spheres{{vec(center), radius}}));
           })
      .def("add_cylinder",
           [](Scene& s, const Three& base, const Three& apex, float radius) {
             return add(s.shapes, Shape(Cylinders{{vec(base), vec(apex), radius}}));
           })
      .def("add_plane",
           [](Scene& s, const Three& point, const Three& normal) {
             return add(s.shapes, Shape(Planes{{vec(point), glm::normalize(vec(normal))}}));
           })
      .def("add_box",
           [](Scene& s, const Three& lower, const Three& upper) {
             return add(s.shapes, Shape(Boxes{{vec(lower), vec(upper)}}));
           })
      .def("add_texture", &add_texture)
      .def("add_material",
           [](Scene& s, const MetallicRoughness& surface) {
             return add(s.materials, Material{"", surface});
           })
      .def("add_instance",
           [](Scene& s, std::string name, int shape, int material, int node) {
             return add(s.instances, Instance{std::move(name), shape, material, node});
           })
      .def("add_light", [](Scene& s, const Light& light) { return add(s.lights, light); })
      .def("add_camera", &add_camera)
      .def("animate", &animate)
      .def("set_display",
           [](Scene& s, int node, float plane_height, float viewing_distance) {
             s.display = DisplayPlacement{node, plane_height, viewing_distance};
           })
      .def("set_background",
           [](Scene& s, const Three& horizon, const Three& zenith) {
             s.background.horizon = vec(horizon), s.background.zenith = vec(zenith), s.background.map.reset();
           })
      .def("set_environment",
           [](Scene& s, const Array<float>& radiance, float strength, float rotation_deg) {
             s.background.map = EnvironmentMap{image_of(radiance, 3, "radiance"), strength, radians(rotation_deg)};
           })
      .def("read_environment", &surround_with_file)
      .def("surround_with_studio", &surround_with_studio)
      .def("turn_upright", [](Scene& s, int axis) { turn_upright(s, static_cast<UpAxis>(axis)); })
      .def("scale_lamps", [](Scene& s, float factor) {
        for (Light& light : s.lights) light.color *= factor;
      });
}

std::vector<std::pair<std::string, std::string>> builtin_scene_lines() {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const BuiltinScene& scene : builtin_scenes()) lines.emplace_back(scene.name, scene.description);
  return lines;
}

/// Replaces the cameras as `render --cameras` does. Returns the frames of the test cameras.
std::vector<int> surround(Scene& scene, const std::string& cameras, std::uint32_t seed) {
  const CameraSet set = read_camera_set(cameras, "cameras");
  surround_with_cameras(scene, set);
  const std::vector<bool> is_test = test_cameras(set.count, seed);
  std::vector<int> tests;
  for (int frame = 0; frame < set.count; ++frame)
    if (is_test[static_cast<std::size_t>(frame)]) tests.push_back(frame);
  return tests;
}

}  // namespace

void bind_scene(py::module_& module) {
  bind_surface(module);
  bind_light(module);
  py::class_<Scene, SharedScene> scene(module, "Scene");
  scene
      .def(py::init([](std::string name, int frames, double frames_per_second) {
        Scene made;
        made.name = std::move(name);
        made.timeline.frame_count = frames, made.timeline.frames_per_second = frames_per_second;
        return std::make_shared<Scene>(std::move(made));
      }))
      .def(pickled<Scene>())
      .def("copy", [](const Scene& s) { return std::make_shared<Scene>(s); })
      .def("check", [](const Scene& s) { validate(s, "scene"); })
      .def("move_near_origin", &move_near_origin)
      .def("add_missing_light",
           [](Scene& s, const Sampling& sampling) { return add_missing_light(s, integrator_of(sampling)); })
      .def_property_readonly("kind", [](const Scene& s) { return word_for(s.kind); })
      .def("bounds", &bounds_of)
      .def_property_readonly("name", [](const Scene& s) { return decoded(s.name); })
      .def_property_readonly("frame_count", [](const Scene& s) { return s.timeline.frame_count; })
      .def_property_readonly("frames_per_second", [](const Scene& s) { return s.timeline.frames_per_second; })
      .def_property_readonly("material_count", [](const Scene& s) { return s.materials.size(); })
      .def_property_readonly("instance_names", [](const Scene& s) { return names_of(s.instances); })
      .def_property_readonly("camera_names", [](const Scene& s) { return names_of(s.cameras); })
      .def("choose_camera", [](Scene& s, const std::string& name) { choose_camera(s, name); })
      .def("choose_camera_at", [](Scene& s, std::size_t index) { choose_camera(s, index); })
      .def("surround_with_cameras", &surround);
  bind_elements(scene);
  py::class_<LoadOptions>(module, "LoadOptions")
      .def(py::init())
      .def_readwrite("camera_path", &LoadOptions::camera_path)
      .def_readwrite("frames_per_second", &LoadOptions::frames_per_second)
      .def_readwrite("asset_root", &LoadOptions::asset_root)
      .def_readwrite("animation", &LoadOptions::animation)
      .def_readwrite("variant", &LoadOptions::variant)
      .def_readwrite("texture_bytes", &LoadOptions::texture_bytes)
      .def_readwrite("point_size", &LoadOptions::point_size);
  module.def("load_scene", &load);
  module.def("builtin_scenes", &builtin_scene_lines);
}

}  // namespace lippmann::python
