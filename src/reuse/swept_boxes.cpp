#include "reuse/swept_boxes.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann {
namespace {

constexpr std::size_t kMaxBoxes = 100000;
constexpr int kPartsPerAxis = 12;               // of meshes with
constexpr std::size_t kTrianglesToPart = 2000;  // or more triangles; smaller ones are halved along each axis

const Bounds3f kEverything{Vec3f(-kInfinity), Vec3f(kInfinity)};

/// Boxes of a mesh's triangles, gathered by the cell of a grid that their first vertex is in.
std::vector<Bounds3f> parts_of(const Mesh& mesh) {
  Bounds3f whole;
  for (const Vec3f& p : mesh.positions) whole.add(p);
  const int cells = mesh.triangles.size() >= kTrianglesToPart ? kPartsPerAxis : 4;
  const Vec3f per_cell = static_cast<float>(cells) / glm::max(whole.size(), Vec3f(1e-30f));
  std::vector<Bounds3f> parts(static_cast<std::size_t>(cells * cells * cells));
  for (const auto& triangle : mesh.triangles) {
    const Vec3f place = (mesh.positions[triangle[0]] - whole.lower) * per_cell;
    const glm::ivec3 cell = glm::clamp(glm::ivec3(place), 0, cells - 1);
    Bounds3f& part = parts[static_cast<std::size_t>((cell.z * cells + cell.y) * cells + cell.x)];
    for (const std::uint32_t vertex : triangle) part.add(mesh.positions[vertex]);
  }
  std::erase_if(parts, [](const Bounds3f& part) { return part.empty(); });
  return parts;
}

/// Exact boxes of analytic shapes, as they lie in their node.
template <class Shapes>
std::vector<Bounds3f> parts_of(const Shapes& shapes) {
  std::vector<Bounds3f> parts;
  for (const auto& shape : shapes) {
    Scene one;
    one.shapes.push_back(Shapes{shape});
    one.instances.push_back({"", 0, -1, -1});
    parts.push_back(finite_bounds(one, {}));
  }
  return parts;
}

/// As transform_bounds, of a box given by centre and half size.
Bounds3f around_transformed(const Affine3f& a, const Mat3f& reach, const Bounds3f& box) {
  const Vec3f center = transform_point(a, box.center()), half = reach * (0.5f * box.size());
  return {center - half, center + half};
}

Mat3f absolute(const Mat3f& m) { return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])}; }

bool contains(const Bounds3f& outer, const Bounds3f& inner) {
  return glm::all(glm::lessThanEqual(outer.lower, inner.lower)) && glm::all(glm::greaterThanEqual(outer.upper, inner.upper));
}

}  // namespace

SweptBoxes::SweptBoxes(const Scene& scene, int display_node) : scene_(scene) {
  const std::vector<bool> moves = moving_nodes(scene);
  const auto is_moving = [&](int node) { return node >= 0 && moves[static_cast<std::size_t>(node)]; };
  if (is_moving(display_node)) decisive_nodes_.push_back(display_node);
  for (const Light& light : scene.lights)
    if (is_moving(light.node)) decisive_nodes_.push_back(light.node);
  for (const Instance& instance : scene.instances) {
    if (!is_moving(instance.node)) continue;
    const Shape& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
    if (std::holds_alternative<Planes>(shape))
      decisive_nodes_.push_back(instance.node);
    else
      instances_.push_back({instance.node, std::visit([](const auto& s) { return parts_of(s); }, shape)});
  }
}

bool SweptBoxes::all_changes(const ResolvedScene& from, const ResolvedScene& to) const {
  return std::any_of(decisive_nodes_.begin(), decisive_nodes_.end(), [&](int node) { return !(from.of(node) == to.of(node)); });
}

std::vector<HorizonBox> SweptBoxes::around(int first, std::span<const int> horizons, int last_frame) const {
  std::vector<ResolvedScene> moments;
  std::vector<HorizonBox> boxes;
  const int last = std::min(first + horizons.back() - 1, last_frame);
  std::size_t known = horizons.size();  // horizons before this one have boxes
  for (int frame = first; frame <= last; ++frame) {
    moments.push_back(evaluate(scene_, scene_.timeline.time(frame)));
    if (!all_changes(moments.front(), moments.back())) continue;
    known = static_cast<std::size_t>(std::upper_bound(horizons.begin(), horizons.end(), frame - first) - horizons.begin());
    boxes.push_back({kEverything, static_cast<std::uint8_t>(known)});
    break;
  }
  for (const MovingInstance& instance : instances_) {
    std::vector<Affine3f> places;
    std::vector<Mat3f> reaches;
    for (const ResolvedScene& moment : moments) {
      places.push_back(moment.of(instance.node));
      reaches.push_back(absolute(places.back().linear));
    }
    const auto moved = std::find_if(places.begin(), places.end(), [&](const Affine3f& p) { return !(p == places.front()); });
    const auto rests_for = static_cast<int>(moved - places.begin());
    for (const Bounds3f& part : instance.parts) {
      Bounds3f swept, told;
      std::size_t frame = 0;
      for (std::size_t h = 0; h < known && frame < places.size(); ++h) {
        for (; frame < places.size() && static_cast<int>(frame) < horizons[h]; ++frame)
          swept.add(around_transformed(places[frame], reaches[frame], part));
        if (rests_for >= horizons[h] || moved == places.end() || contains(told, swept)) continue;
        boxes.push_back({swept, static_cast<std::uint8_t>(h)});
        told = swept;
      }
    }
  }
  return boxes;
}

}  // namespace lippmann
