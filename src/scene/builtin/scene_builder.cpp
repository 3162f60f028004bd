#include "scene/builtin/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "scene/builtin/meshes.hpp"
#include "scene/builtin/textures.hpp"

namespace lippmann::builtin {
namespace {

// A cubic spline with this many keys per cycle deviates from a sine by less than 1e-4 of its amplitude.
constexpr int kKeysPerCycle = 16;

// In units of the height of the array. The backdrop is wide enough for the outermost rays of a wide array.
constexpr float kBackdropDistance = 1.2f, kBackdropHalfWidth = 1.6f, kBackdropHalfHeight = 1.0f;

/// Calls add(time, value, slope per second) for each spline key of an oscillation. The last key equals the first one exactly.
template <class Add>
void for_each_key(const Swing& swing, const Add& add) {
  const int keys = kKeysPerCycle * swing.cycles;
  const double angular_speed = 2.0 * std::numbers::pi * swing.cycles / kLoopSeconds;
  for (int key = 0; key <= keys; ++key) {
    const double cycle = static_cast<double>(key % kKeysPerCycle) / kKeysPerCycle + static_cast<double>(swing.phase);
    const double angle = 2.0 * std::numbers::pi * cycle;
    add(kLoopSeconds * key / keys, static_cast<float>(swing.amplitude * std::sin(angle)),
        static_cast<float>(swing.amplitude * std::cos(angle) * angular_speed));
  }
}

}  // namespace

Transform at(Vec3f translation, float scale) { return {translation, {1.0f, 0.0f, 0.0f, 0.0f}, Vec3f(scale)}; }

Transform turned(Vec3f translation, Vec3f unit_axis, float angle, float scale) {
  return {translation, glm::angleAxis(angle, unit_axis), Vec3f(scale)};
}

PhongSurface matte(Vec3f color) {
  PhongSurface surface;
  surface.color = color;
  surface.ambient = 0.22f;
  surface.diffuse = 0.78f;
  return surface;
}

PhongSurface glossy(Vec3f color, float highlight, float highlight_size, float mirror) {
  PhongSurface surface = matte(color);
  surface.highlight_kind = Highlight::kPlastic;
  surface.highlight = highlight;
  surface.highlight_size = highlight_size;
  surface.mirror = mirror;
  return surface;
}

PhongSurface polished_metal(Vec3f color, float mirror) {
  PhongSurface surface = matte(color);
  surface.ambient = 0.15f;
  surface.diffuse = 0.45f;
  surface.highlight_kind = Highlight::kMetal;
  surface.highlight = 0.6f;
  surface.highlight_size = 14.0f;
  surface.mirror = mirror;
  return surface;
}

SceneBuilder::SceneBuilder(std::string name) {
  scene_.name = std::move(name);
  scene_.timeline.frames_per_second = kFramesPerSecond;
  scene_.timeline.frame_count = kFrameCount;
}

int SceneBuilder::add_node(std::string name, int parent, const Transform& local) {
  scene_.nodes.push_back({std::move(name), parent, local, std::nullopt});
  return static_cast<int>(scene_.nodes.size()) - 1;
}

int SceneBuilder::add_shape(Shape shape) {
  scene_.shapes.push_back(std::move(shape));
  return static_cast<int>(scene_.shapes.size()) - 1;
}

int SceneBuilder::add_texture(Texture texture) {
  scene_.textures.push_back(std::move(texture));
  return static_cast<int>(scene_.textures.size()) - 1;
}

int SceneBuilder::add_material(std::string name, const PhongSurface& surface) {
  scene_.materials.push_back({std::move(name), surface});
  return static_cast<int>(scene_.materials.size()) - 1;
}

void SceneBuilder::show(std::string name, int shape, int material, int node) {
  scene_.instances.push_back({std::move(name), shape, material, node});
}

NodeAnimation& SceneBuilder::animation_of(int node) {
  for (NodeAnimation& a : scene_.timeline.animations)
    if (a.node == node) return a;
  scene_.timeline.animations.emplace_back().node = node;
  return scene_.timeline.animations.back();
}

void SceneBuilder::spin(int node, Vec3f unit_axis, int turns, float start) {
  constexpr int kKeysPerTurn = 4;
  const int keys = kKeysPerTurn * std::abs(turns);
  const Quatf rest = scene_.nodes[static_cast<std::size_t>(node)].local.rotation;
  Channel<Quatf>& rotation = animation_of(node).rotation;
  for (int key = 0; key <= keys; ++key) {
    const int quarter = (turns < 0 ? kKeysPerTurn - key % kKeysPerTurn : key) % kKeysPerTurn;
    const double turn = static_cast<double>(quarter) / kKeysPerTurn + static_cast<double>(start);
    rotation.times.push_back(kLoopSeconds * key / keys);
    rotation.values.push_back(rest * glm::angleAxis(static_cast<float>(2.0 * std::numbers::pi * turn), unit_axis));
  }
}

void SceneBuilder::swing(int node, Vec3f unit_axis, const Swing& swing) {
  const Quatf rest = scene_.nodes[static_cast<std::size_t>(node)].local.rotation;
  Channel<Quatf>& rotation = animation_of(node).rotation;
  rotation.interpolation = Interpolation::kCubicSpline;
  for_each_key(swing, [&](double time, float angle, float slope) {
    const float s = std::sin(0.5f * angle), c = std::cos(0.5f * angle);
    const Quatf tangent = rest * ((0.5f * slope) * Quatf(-s, c * unit_axis));
    rotation.times.push_back(time);
    rotation.values.insert(rotation.values.end(), {tangent, rest * Quatf(c, s * unit_axis), tangent});
  });
}

void SceneBuilder::bob(int node, Vec3f unit_direction, const Swing& swing) {
  const Vec3f rest = scene_.nodes[static_cast<std::size_t>(node)].local.translation;
  Channel<Vec3f>& translation = animation_of(node).translation;
  translation.interpolation = Interpolation::kCubicSpline;
  for_each_key(swing, [&](double time, float offset, float slope) {
    const Vec3f tangent = slope * unit_direction;
    translation.times.push_back(time);
    translation.values.insert(translation.values.end(), {tangent, rest + offset * unit_direction, tangent});
  });
}

void SceneBuilder::add_light(std::string name, Vec3f position, Vec3f color) {
  Light light;
  light.node = add_node(name, -1, at(position));
  light.name = std::move(name);
  light.color = color;
  scene_.lights.push_back(std::move(light));
}

void SceneBuilder::add_backdrop(Vec3f glow, Vec3f edge) {
  const float height = scene_.display->plane_height;
  const Texture cloth = paint("backdrop", 256, 256, [=](Vec2f uv) {
    const float distance = 2.0f * glm::length((uv - Vec2f(0.5f, 0.42f)) * Vec2f(1.4f, 1.0f));
    const float t = std::clamp(1.0f - distance, 0.0f, 1.0f);
    // The noise of about one 8-bit step hides banding in the slow gradient.
    return glm::mix(edge, glow, t * t * (3.0f - 2.0f * t)) * (1.0f + 0.02f * noise(256.0f * uv + 0.5f, {256, 256}, 3));
  });
  PhongSurface painted = matte(Vec3f(1.0f));
  painted.ambient = 1.0f;
  painted.diffuse = 0.0f;
  painted.texture = add_texture(cloth);
  show("backdrop",
       rectangle({0.0f, 0.0f, -kBackdropDistance * height}, {kBackdropHalfWidth * height, 0.0f, 0.0f},
                 {0.0f, kBackdropHalfHeight * height, 0.0f}),
       add_material("backdrop", painted), scene_.display->node);
}

int SceneBuilder::set_display(Vec3f center, float yaw, float pitch, float plane_height, float viewing_distance) {
  const Quatf turn = glm::angleAxis(yaw, Vec3f(0, 1, 0)) * glm::angleAxis(-pitch, Vec3f(1, 0, 0));
  const int display = add_node("display", -1, {center, turn, Vec3f(1.0f)});
  scene_.display = DisplayPlacement{display, plane_height, viewing_distance};

  Camera camera;
  camera.name = "viewer";
  camera.node = add_node("viewer", display, at({0.0f, 0.0f, viewing_distance}));
  camera.vertical_fov = 2.0f * std::atan(0.5f * plane_height / viewing_distance);
  camera.focus_distance = viewing_distance;
  scene_.cameras.push_back(std::move(camera));
  return display;
}

}  // namespace lippmann::builtin
