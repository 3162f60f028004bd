#include "scene/builtin/foliage.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "scene/builtin/meshes.hpp"

namespace lippmann::builtin {
namespace {

constexpr float kGoldenAngle = 2.39996323f;

/// Adds a rhombus from `base` to `base + along` with half width `side`. Both halves rise towards `up`.
void add_leaf(Mesh& mesh, Vec3f base, Vec3f along, Vec3f side, Vec3f up, Vec3f shading_normal) {
  const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
  const Vec3f middle = base + 0.55f * along, lift = 0.25f * glm::length(side) * up;
  for (const Vec3f& p : {base, middle + side + lift, base + along, middle - side + lift}) {
    mesh.positions.push_back(p);
    mesh.normals.push_back(shading_normal);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

struct Twig {
  Vec3f from, to;
};

void add_twig(Mesh& mesh, const Twig& twig, float radius) {
  append(mesh, tube({twig.from, twig.to}, {radius, 0.5f * radius}, 4, false));
}

std::vector<Twig> side_twigs(const Twig& twig, int count, float length, Dice& dice) {
  std::vector<Twig> twigs;
  const Vec3f axis = twig.to - twig.from;
  const Quatf frame = growing_towards(glm::normalize(axis), 0.0f);
  for (int i = 0; i < count; ++i) {
    const float share = glm::mix(0.2f, 1.0f, (static_cast<float>(i) + dice.unit()) / static_cast<float>(count));
    const float lean = radians(dice.between(35.0f, 65.0f)) * (1.15f - 0.6f * share);
    const Vec3f direction = frame * leaning(lean, kGoldenAngle * static_cast<float>(i) + dice.between(-0.4f, 0.4f));
    const Vec3f from = twig.from + share * axis;
    twigs.push_back({from, from + length * dice.between(0.7f, 1.1f) * (1.1f - 0.5f * share) * direction});
  }
  return twigs;
}

Vec3f any_direction(Dice& dice) {
  const float z = dice.between(-1.0f, 1.0f), bearing = 2.0f * kPi * dice.unit(), r = std::sqrt(std::max(0.0f, 1.0f - z * z));
  return {r * std::cos(bearing), z, r * std::sin(bearing)};
}

}  // namespace

std::uint32_t Dice::bits() { return hash(seed_, count_++); }

float Dice::unit() { return unit_float(bits()); }

Vec3f Branch::point(float share) const {
  const float at = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(points.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), points.size() - 2);
  return glm::mix(points[i], points[i + 1], at - static_cast<float>(i));
}

Branch bent_branch(float length, float base_radius, float tip_radius, float bend, int pieces, std::uint32_t seed) {
  Dice dice(seed);
  const Vec2f drift = bend * Vec2f(dice.between(-1.0f, 1.0f), dice.between(-1.0f, 1.0f));
  const Vec2f wave = 0.5f * bend * Vec2f(dice.between(-1.0f, 1.0f), dice.between(-1.0f, 1.0f));
  Branch branch;
  for (int i = 0; i <= pieces; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(pieces);
    const Vec2f off = length * (t * t * drift + std::sin(2.0f * kPi * t) * t * wave);
    branch.points.push_back({off.x, length * t, off.y});
    branch.radii.push_back(glm::mix(base_radius, tip_radius, t));
  }
  return branch;
}

Quatf growing_towards(Vec3f direction, float roll) {
  constexpr Vec3f kYAxis(0.0f, 1.0f, 0.0f);
  return glm::normalize(Quatf(kYAxis, direction) * glm::angleAxis(roll, kYAxis));
}

Vec3f leaning(float angle, float bearing) {
  return {std::sin(angle) * std::cos(bearing), std::cos(angle), std::sin(angle) * std::sin(bearing)};
}

Spray grow_spray(float length, int leaf_count, float leaf_length, std::uint32_t seed) {
  Dice dice(seed);
  Spray spray;
  const Twig stem{Vec3f(0.0f), {0.0f, 0.8f * length, 0.0f}};
  add_twig(spray.twigs, stem, 0.012f * length);
  std::vector<Twig> leafy;
  for (const Twig& side : side_twigs(stem, 9, 0.55f * length, dice)) {
    add_twig(spray.twigs, side, 0.006f * length);
    for (const Twig& twig : side_twigs(side, 5, 0.25f * length, dice)) {
      add_twig(spray.twigs, twig, 0.003f * length);
      leafy.push_back(twig);
    }
    leafy.push_back(side);
  }

  const Vec3f center(0.0f, 0.5f * length, 0.0f);
  for (int i = 0; i < leaf_count; ++i) {
    const Twig& twig = leafy[dice.bits() % leafy.size()];
    const Vec3f base = glm::mix(twig.from, twig.to, dice.between(0.15f, 1.05f)) + 0.035f * length * any_direction(dice);
    const Vec3f outwards = glm::normalize(base - center + 1e-4f * any_direction(dice));
    Vec3f up = glm::normalize(outwards + 0.9f * any_direction(dice));
    if (glm::dot(up, outwards) < 0.0f) up = -up;
    const Vec3f along = glm::normalize(glm::cross(up, any_direction(dice)));
    const Vec3f side = glm::cross(along, up);
    const float size = leaf_length * dice.between(0.75f, 1.2f);
    add_leaf(spray.leaves, base, size * along, 0.3f * size * side, up, glm::normalize(0.6f * up + 0.8f * outwards));
  }
  return spray;
}

}  // namespace lippmann::builtin
