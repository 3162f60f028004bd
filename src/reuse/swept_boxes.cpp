#include "reuse/swept_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "scene/deform.hpp"
#include "scene/splats.hpp"

namespace lippmann {
namespace {

// grid cells along each axis of a mesh; 4 if the mesh has fewer than kTrianglesToPart triangles
constexpr int kPartsPerAxis = 12;
constexpr std::size_t kTrianglesToPart = 2000;

const Bounds3f kEverything{Vec3f(-kInfinity), Vec3f(kInfinity)};

/// Groups the triangles of a mesh by the grid cell that holds their first vertex.
std::vector<std::vector<std::size_t>> triangles_by_part(const Mesh& mesh) {
  Bounds3f whole;
  for (const Vec3f& p : mesh.positions) whole.add(p);
  const int cells = mesh.triangles.size() >= kTrianglesToPart ? kPartsPerAxis : 4;
  const Vec3f per_cell = static_cast<float>(cells) / glm::max(whole.size(), Vec3f(1e-30f));
  std::vector<std::vector<std::size_t>> parts(static_cast<std::size_t>(cells * cells * cells));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3f place = (mesh.positions[mesh.triangles[t][0]] - whole.lower) * per_cell;
    const glm::ivec3 cell = glm::clamp(glm::ivec3(place), 0, cells - 1);
    parts[static_cast<std::size_t>((cell.z * cells + cell.y) * cells + cell.x)].push_back(t);
  }
  std::erase_if(parts, [](const auto& part) { return part.empty(); });
  return parts;
}

std::vector<Bounds3f> parts_of(const Mesh& mesh) {
  std::vector<Bounds3f> boxes;
  for (const std::vector<std::size_t>& part : triangles_by_part(mesh)) {
    Bounds3f& box = boxes.emplace_back();
    for (const std::size_t t : part)
      for (const std::uint32_t vertex : mesh.triangles[t]) box.add(mesh.positions[vertex]);
  }
  return boxes;
}

std::vector<std::vector<std::uint32_t>> vertices_by_part(const Mesh& mesh) {
  std::vector<std::vector<std::uint32_t>> vertices;
  for (const std::vector<std::size_t>& part : triangles_by_part(mesh)) {
    std::vector<std::uint32_t>& of_part = vertices.emplace_back();
    for (const std::size_t t : part) of_part.insert(of_part.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    std::sort(of_part.begin(), of_part.end());
    of_part.erase(std::unique(of_part.begin(), of_part.end()), of_part.end());
  }
  return vertices;
}

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

/// One box around all visible splats: one per splat would be too many.
std::vector<Bounds3f> parts_of(const Splats& splats) { return {whole_bounds(splats, {})}; }

Bounds3f around_transformed(const Affine3f& a, const Mat3f& reach, const Bounds3f& box) {
  const Vec3f center = transform_point(a, box.center()), half = reach * (0.5f * box.size());
  return {center - half, center + half};
}

Mat3f absolute(const Mat3f& m) { return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])}; }

bool contains(const Bounds3f& outer, const Bounds3f& inner) {
  return glm::all(glm::lessThanEqual(outer.lower, inner.lower)) && glm::all(glm::greaterThanEqual(outer.upper, inner.upper));
}

/// Adds the boxes of one part of a mesh, at most one per horizon. The part does not move during the first `rests_for` frames.
template <class BoxAt>
void add_boxes(std::size_t frames, std::size_t rests_for, std::span<const int> horizons, std::vector<HorizonBox>& boxes,
               const BoxAt& box_at) {
  Bounds3f swept, bounded;
  std::size_t frame = 0;
  for (std::size_t h = 0; h < horizons.size() && frame < frames; ++h) {
    const auto horizon = static_cast<std::size_t>(horizons[h]);
    for (; frame < std::min(frames, horizon); ++frame) swept.add(box_at(frame));
    if (rests_for >= horizon || rests_for == frames || contains(bounded, swept)) continue;
    boxes.push_back({swept, static_cast<std::uint8_t>(h)});
    bounded = swept;
  }
}

}  // namespace

SweptBoxes::SweptBoxes(const Scene& scene, int display_node) : scene_(scene) {
  const std::vector<bool> moves = moving_nodes(scene);
  const auto is_moving = [&](int node) { return node >= 0 && moves[static_cast<std::size_t>(node)]; };
  if (is_moving(display_node)) decisive_nodes_.push_back(display_node);
  for (const Light& light : scene.lights)
    if (is_moving(light.node)) decisive_nodes_.push_back(light.node);
  const std::vector<bool> instance_moves = moving_instances(scene);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (!instance_moves[i]) continue;
    const Instance& instance = scene.instances[i];
    const Shape& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
    if (is_posed(scene, instance))
      posed_.push_back({i, vertices_by_part(std::get<Mesh>(shape))});
    else if (std::holds_alternative<Planes>(shape))
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
  std::size_t known = horizons.size();
  for (int frame = first; frame <= last; ++frame) {
    moments.push_back(evaluate(scene_, scene_.timeline.time(frame)));
    if (!all_changes(moments.front(), moments.back())) continue;
    known = static_cast<std::size_t>(std::upper_bound(horizons.begin(), horizons.end(), frame - first) - horizons.begin());
    boxes.push_back({kEverything, static_cast<std::uint8_t>(known)});
    break;
  }
  const std::span<const int> bounded = horizons.first(known);
  for (const MovingInstance& instance : instances_) add_swept(instance, moments, bounded, boxes);
  for (const PosedInstance& instance : posed_) add_swept(instance, moments, bounded, boxes);
  return boxes;
}

void SweptBoxes::add_swept(const MovingInstance& instance, std::span<const ResolvedScene> moments,
                           std::span<const int> horizons, std::vector<HorizonBox>& boxes) const {
  std::vector<Affine3f> places;
  std::vector<Mat3f> reaches;
  for (const ResolvedScene& moment : moments) {
    places.push_back(moment.of(instance.node));
    reaches.push_back(absolute(places.back().linear));
  }
  const auto moved = std::find_if(places.begin(), places.end(), [&](const Affine3f& p) { return !(p == places.front()); });
  const auto rests_for = static_cast<std::size_t>(moved - places.begin());
  for (const Bounds3f& part : instance.parts)
    add_boxes(places.size(), rests_for, horizons, boxes,
              [&](std::size_t frame) { return around_transformed(places[frame], reaches[frame], part); });
}

void SweptBoxes::add_swept(const PosedInstance& posed, std::span<const ResolvedScene> moments, std::span<const int> horizons,
                           std::vector<HorizonBox>& boxes) const {
  const std::size_t frames = moments.size();
  std::vector<std::vector<Bounds3f>> box(posed.parts.size(), std::vector<Bounds3f>(frames));
  std::vector<std::size_t> rests_for(posed.parts.size(), frames);
  const MeshPose first(scene_, scene_.instances[posed.instance], moments.front());
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const MeshPose pose(scene_, scene_.instances[posed.instance], moments[frame]);
    for (std::size_t part = 0; part < posed.parts.size(); ++part)
      for (const std::uint32_t v : posed.parts[part]) {
        const PosedVertex vertex = pose.vertex(v);
        box[part][frame].add(vertex.position);
        if (rests_for[part] == frames && !(vertex == first.vertex(v))) rests_for[part] = frame;
      }
  }
  for (std::size_t part = 0; part < posed.parts.size(); ++part)
    add_boxes(frames, rests_for[part], horizons, boxes, [&](std::size_t frame) { return box[part][frame]; });
}

}  // namespace lippmann
