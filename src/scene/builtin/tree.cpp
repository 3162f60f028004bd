// The scene "tree": an autumn maple on an island in the sky. Limbs, boughs and sprays sway as rigid pieces. Instances of a few
// meshes make up about 900,000 triangles. The unit of length is the metre.
#include <array>
#include <cmath>

#include "scene/builtin/foliage.hpp"
#include "scene/builtin/meshes.hpp"
#include "scene/builtin/scene_builder.hpp"
#include "scene/builtin/scenes.hpp"
#include "scene/builtin/textures.hpp"

namespace lippmann::builtin {
namespace {

constexpr int kLimbs = 9, kBoughsPerLimb = 6, kSpraysPerBough = 4;
constexpr int kVariants = 3;
constexpr int kLeavesPerSpray = 1750;
constexpr float kLeafLength = 0.055f;

struct Pose {
  int node = -1;
  Quatf rotation{1.0f, 0.0f, 0.0f, 0.0f};
  Vec3f position{0.0f};
};

class TreeGrower {
 public:
  explicit TreeGrower(SceneBuilder& scene) : scene_(scene), dice_(20) {}

  void grow() {
    make_materials();
    make_shared_shapes();
    const Branch trunk = bent_branch(2.6f, 0.34f, 0.20f, 0.06f, 24, 5);
    scene_.show("trunk", trunk_mesh(trunk), bark_, -1);
    for (int i = 0; i < kLimbs; ++i) grow_limb(trunk, i);
  }

 private:
  void make_materials() {
    PhongSurface bark = matte(Vec3f(1.0f));
    bark.texture = scene_.add_texture(paint("bark", 256, 256, [](Vec2f uv) {
      const float furrow = fractal_noise({14.0f * uv.x, 3.0f * uv.y}, {14, 3}, 4, 77);
      return Vec3f(0.16f, 0.10f, 0.065f) * (1.0f + 0.9f * furrow);
    }));
    bark_ = scene_.add_material("bark", bark);
    wood_ = scene_.add_material("wood", matte({0.13f, 0.08f, 0.05f}));
    constexpr Vec3f kLeafColors[] = {
        {0.50f, 0.035f, 0.02f}, {0.78f, 0.14f, 0.02f}, {0.90f, 0.36f, 0.03f}, {0.85f, 0.58f, 0.06f}};
    for (std::size_t i = 0; i < leaf_.size(); ++i)
      leaf_[i] = scene_.add_material("leaves", glossy(kLeafColors[i], 0.08f, 12.0f));
  }

  void make_shared_shapes() {
    for (std::uint32_t v = 0; v < kVariants; ++v) {
      limbs_[v] = bent_branch(2.5f, 0.15f, 0.05f, 0.16f, 16, 100 + v);
      boughs_[v] = bent_branch(1.3f, 0.05f, 0.014f, 0.16f, 10, 200 + v);
      limb_shape_[v] = scene_.add_shape(tube(limbs_[v].points, limbs_[v].radii, 14, false));
      bough_shape_[v] = scene_.add_shape(tube(boughs_[v].points, boughs_[v].radii, 8, false));
      Spray spray = grow_spray(0.85f, kLeavesPerSpray, kLeafLength, 300 + v);
      twigs_shape_[v] = scene_.add_shape(std::move(spray.twigs));
      leaves_shape_[v] = scene_.add_shape(std::move(spray.leaves));
    }
  }

  static Mesh trunk_mesh(Branch trunk) {
    for (std::size_t i = 0; i < trunk.points.size(); ++i) {
      const float height = trunk.points[i].y;
      trunk.radii[i] += 0.30f * std::exp(-4.5f * height);
      trunk.points[i].y = height - 0.15f;
    }
    return tube(trunk.points, trunk.radii, 32, false);
  }

  /// Attaches a piece at `place` in the parent's frame. It grows along `direction`, in world space, and sways about a
  /// horizontal axis. Returns its pose.
  Pose attach(const char* name, const Pose& parent, Vec3f place, Vec3f direction, const Swing& sway, float scale = 1.0f) {
    Pose pose;
    pose.rotation = growing_towards(direction, 2.0f * kPi * dice_.unit());
    pose.position = parent.position + parent.rotation * place;
    const Quatf local = glm::normalize(glm::conjugate(parent.rotation) * pose.rotation);
    pose.node = scene_.add_node(name, parent.node, {place, local, Vec3f(scale)});
    const Vec3f wind(1.0f, 0.0f, 0.25f);
    const Vec3f level = glm::normalize(glm::cross(wind, kUp) + 0.3f * Vec3f(dice_.between(-1, 1), 0.0f, dice_.between(-1, 1)));
    scene_.swing(pose.node, glm::conjugate(pose.rotation) * level, sway);
    return pose;
  }

  void grow_limb(const Branch& trunk, int index) {
    const float share = static_cast<float>(index) / (kLimbs - 1);
    const float lean = radians(glm::mix(74.0f, 6.0f, share) + dice_.between(-4.0f, 4.0f));
    const Vec3f direction = leaning(lean, 2.39996323f * static_cast<float>(index) + 0.4f);
    const Vec3f place = trunk.point(glm::mix(0.64f, 0.98f, share)) - Vec3f(0.0f, 0.15f, 0.0f);
    const Swing sway{radians(1.4f), 2, dice_.between(0.0f, 0.25f)};
    const Pose pose = attach("limb", {}, place, direction, sway, glm::mix(1.0f, 0.85f, share));
    const std::size_t variant = static_cast<std::size_t>(index) % kVariants;
    scene_.show("limb", limb_shape_[variant], wood_, pose.node);
    for (int i = 0; i < kBoughsPerLimb; ++i) grow_bough(pose, limbs_[variant], i);
  }

  void grow_bough(const Pose& limb, const Branch& branch, int index) {
    const float share = glm::mix(0.36f, 1.0f, static_cast<float>(index) / (kBoughsPerLimb - 1));
    const float lean = radians(glm::mix(72.0f, 10.0f, share) + dice_.between(-6.0f, 6.0f));
    const Vec3f direction = limb.rotation * leaning(lean, 2.39996323f * static_cast<float>(index) + dice_.between(-0.3f, 0.3f));
    const Vec3f lifted = glm::normalize(direction + 0.25f * kUp);
    const Swing sway{radians(2.8f), 3, dice_.unit()};
    const Pose pose = attach("bough", limb, branch.point(share), lifted, sway, dice_.between(0.85f, 1.1f));
    const std::size_t variant = dice_.bits() % kVariants;
    scene_.show("bough", bough_shape_[variant], wood_, pose.node);
    for (int i = 0; i < kSpraysPerBough; ++i) grow_spray_on(pose, boughs_[variant], i);
  }

  void grow_spray_on(const Pose& bough, const Branch& branch, int index) {
    const float share = glm::mix(0.35f, 1.0f, static_cast<float>(index) / (kSpraysPerBough - 1));
    const float lean = radians(glm::mix(70.0f, 5.0f, share) + dice_.between(-8.0f, 8.0f));
    const Vec3f direction =
        bough.rotation * leaning(lean, 2.39996323f * static_cast<float>(index) + dice_.between(-0.5f, 0.5f));
    const Vec3f lifted = glm::normalize(direction + 0.15f * kUp);
    const Swing sway{radians(4.5f), 5, dice_.unit()};
    const Pose pose = attach("spray", bough, branch.point(share), lifted, sway, dice_.between(0.8f, 1.15f));
    const std::size_t variant = dice_.bits() % kVariants;
    scene_.show("twigs", twigs_shape_[variant], wood_, pose.node);
    // Leaves are redder at the top and towards -x, the sunny side.
    const float warmth = 0.32f * (pose.position.y - 4.2f) - 0.16f * pose.position.x + dice_.between(-0.9f, 0.9f);
    const std::size_t color = warmth > 0.75f ? 0 : warmth > 0.1f ? 1 : warmth > -0.55f ? 2 : 3;
    scene_.show("leaves", leaves_shape_[variant], leaf_[color], pose.node);
  }

  SceneBuilder& scene_;
  Dice dice_;
  int bark_ = -1, wood_ = -1;
  std::array<int, 4> leaf_{};
  std::array<Branch, kVariants> limbs_, boughs_;
  std::array<int, kVariants> limb_shape_{}, bough_shape_{}, twigs_shape_{}, leaves_shape_{};
};

void add_island(SceneBuilder& scene) {
  constexpr float kRadius = 3.4f;
  PhongSurface grass = matte(Vec3f(1.0f));
  grass.texture = scene.add_texture(paint("grass", 512, 512, [](Vec2f uv) {
    const float patch = fractal_noise(8.0f * uv, {8, 8}, 5, 201), blade = noise(128.0f * uv, {128, 128}, 202);
    Vec3f color =
        glm::mix(Vec3f(0.10f, 0.20f, 0.03f), Vec3f(0.24f, 0.30f, 0.06f), 0.5f + 0.5f * patch) * (1.0f + 0.35f * blade);
    const Vec2f cell = glm::floor(96.0f * uv);
    Dice dice(static_cast<std::uint32_t>(cell.x) * 1000u + static_cast<std::uint32_t>(cell.y));
    const float fallen = 0.55f - 0.9f * glm::length(uv - 0.5f);
    if (dice.unit() < fallen) color = glm::mix(Vec3f(0.55f, 0.08f, 0.02f), Vec3f(0.80f, 0.45f, 0.05f), dice.unit());
    return color;
  }));
  const std::vector<Vec2f> profile = smooth_profile(
      {{kRadius, -0.42f}, {kRadius + 0.02f, -0.34f}, {kRadius - 0.1f, -0.24f}, {2.4f, -0.10f}, {1.0f, -0.02f}, {0.0f, 0.0f}},
      8);
  Mesh top = lathe(profile, 128);
  for (std::size_t i = 0; i < top.positions.size(); ++i)
    top.uvs[i] = 0.5f + Vec2f(top.positions[i].x, top.positions[i].z) / (2.0f * kRadius + 0.1f);
  scene.show("grass", std::move(top), scene.add_material("grass", grass), -1);

  Mesh rock = lathe(
      smooth_profile(
          {{0.0f, -2.5f}, {0.4f, -2.3f}, {1.0f, -1.9f}, {1.9f, -1.55f}, {2.5f, -1.1f}, {3.1f, -0.8f}, {kRadius, -0.42f}}, 10),
      160);
  // Noise that is periodic around the rock makes it look weathered.
  std::vector<Vec3f>& points = rock.positions;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2f uv = rock.uvs[i];
    const float weight = std::sin(kPi * uv.y);
    const float out = 1.0f + 0.35f * weight * fractal_noise({16.0f * std::fmod(uv.x, 1.0f), 6.0f * uv.y}, {16, 6}, 4, 301);
    points[i] *= Vec3f(out, 1.0f, out);
  }
  rock.normals.clear();
  rock.uvs.clear();
  scene.show("rock", std::move(rock), scene.add_material("rock", matte({0.30f, 0.23f, 0.17f})), -1);
}

}  // namespace

Scene build_tree() {
  SceneBuilder scene("tree");
  TreeGrower(scene).grow();
  add_island(scene);
  scene.add_light("sun", {-9.0f, 13.0f, 10.0f}, {1.00f, 0.90f, 0.74f});
  scene.add_light("sky", {7.0f, 0.5f, 13.0f}, {0.22f, 0.27f, 0.36f});
  scene.set_background({0.45f, 0.55f, 0.68f}, {0.20f, 0.38f, 0.70f});
  constexpr float kPlaneHeight = 9.8f;
  scene.set_display({0.0f, 2.35f, 0.0f}, 0.0f, radians(7.0f), kPlaneHeight, 3.0f * kPlaneHeight);
  scene.add_backdrop({0.62f, 0.74f, 0.84f}, {0.12f, 0.27f, 0.50f});
  return scene.take();
}

}  // namespace lippmann::builtin
