// Based on: Ivan E. Sutherland, Gary W. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17(1), 1974. A polygon
// is clipped by one plane after another. Each clip keeps the corners on the inner side and adds a corner where an edge crosses
// the plane.
#include "stage/seen_bounds.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "scene/deform.hpp"

namespace lippmann {
namespace {

using Polygon = std::vector<Vec3f>;

class Clipper {
 public:
  Clipper(const ConvexRegion& region, const PolygonVisitor& visit) : region_(region), visit_(visit) {}

  void add_triangle(Vec3f a, Vec3f b, Vec3f c) {
    polygon_.assign({a, b, c});
    clip();
  }

  void add_quad(Vec3f a, Vec3f b, Vec3f c, Vec3f d) {
    polygon_.assign({a, b, c, d});
    clip();
  }

 private:
  void clip() {
    for (const HalfSpace& side : region_) {
      cut(side);
      if (polygon_.empty()) return;
    }
    visit_(polygon_);
  }

  void cut(const HalfSpace& side) {
    kept_.clear();
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Vec3f from = polygon_[i], to = polygon_[(i + 1) % polygon_.size()];
      const float d_from = glm::dot(side.normal, from) + side.offset, d_to = glm::dot(side.normal, to) + side.offset;
      if (d_from >= 0.0f) kept_.push_back(from);
      if ((d_from >= 0.0f) != (d_to >= 0.0f)) kept_.push_back(from + (d_from / (d_from - d_to)) * (to - from));
    }
    polygon_.swap(kept_);
  }

  const ConvexRegion& region_;
  const PolygonVisitor& visit_;
  Polygon polygon_, kept_;
};

void add_mesh(Clipper& clipper, const Mesh& mesh, const std::vector<Vec3f>& positions) {
  for (const auto& [a, b, c] : mesh.triangles) clipper.add_triangle(positions[a], positions[b], positions[c]);
}

void add_box(Clipper& clipper, const Bounds3f& box) {
  if (box.empty()) return;
  std::array<Vec3f, 8> corner;
  for (int i = 0; i < 8; ++i)
    corner[static_cast<std::size_t>(i)] = {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                                           i & 4 ? box.upper.z : box.lower.z};
  constexpr std::array<std::array<std::size_t, 4>, 6> kFaces{
      {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
  for (const auto& [a, b, c, d] : kFaces) clipper.add_quad(corner[a], corner[b], corner[c], corner[d]);
}

std::vector<Vec3f> positions_of(const Scene& scene, const Instance& instance, const ResolvedScene& resolved,
                                const Affine3f& frame_from_world, const Mesh& mesh) {
  std::vector<Vec3f> positions(mesh.positions.size());
  if (is_posed(scene, instance)) {
    const MeshPose pose(scene, instance, resolved);
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = transform_point(frame_from_world, pose.position(i));
    return positions;
  }
  const Affine3f frame_from_node = frame_from_world * resolved.of(instance.node);
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = transform_point(frame_from_node, mesh.positions[i]);
  return positions;
}

}  // namespace

ConvexRegion view_region(Vec3f eye, Vec2f tangent) {
  ConvexRegion region;
  const auto add = [&](Vec3f normal) { region.push_back({normal, -glm::dot(normal, eye)}); };
  for (const float sign : {1.0f, -1.0f}) {
    add(glm::normalize(Vec3f(sign, 0.0f, -tangent.x)));
    add(glm::normalize(Vec3f(0.0f, sign, -tangent.y)));
  }
  add({0.0f, 0.0f, -1.0f});
  return region;
}

ConvexRegion beam_region(Vec2f half) {
  ConvexRegion region{{{0.0f, 0.0f, -1.0f}, 0.0f}};
  for (const float sign : {1.0f, -1.0f}) {
    region.push_back({{sign, 0.0f, 0.0f}, half.x});
    region.push_back({{0.0f, sign, 0.0f}, half.y});
  }
  return region;
}

ConvexRegion box_region(const Bounds3f& box) {
  ConvexRegion region;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3f normal(0.0f);
    normal[axis] = 1.0f;
    region.push_back({normal, -box.lower[axis]});
    region.push_back({-normal, box.upper[axis]});
  }
  return region;
}

void visit_boxes(const Scene& scene, const Instance& instance, const ResolvedScene& resolved, const Affine3f& frame_from_world,
                 const std::function<void(const Bounds3f&)>& visit) {
  Instance alone = instance;
  alone.shape = 0;
  std::visit(
      [&](const auto& shape) {
        if constexpr (requires { shape.front(); }) {
          Scene one;
          one.shapes.resize(1);
          for (const auto& primitive : shape) {
            one.shapes[0] = std::decay_t<decltype(shape)>{primitive};
            visit(finite_bounds(one, alone, resolved, frame_from_world));
          }
        }
      },
      scene.shapes[static_cast<std::size_t>(instance.shape)]);
}

void visit_seen(const Scene& scene, const Instance& instance, const ResolvedScene& resolved, const Affine3f& frame_from_world,
                const ConvexRegion& region, const PolygonVisitor& visit) {
  Clipper clipper(region, visit);
  std::visit(
      [&](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Mesh>)
          add_mesh(clipper, shape, positions_of(scene, instance, resolved, frame_from_world, shape));
        else if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Splats>)
          add_box(clipper, finite_bounds(scene, instance, resolved, frame_from_world));
        else
          visit_boxes(scene, instance, resolved, frame_from_world, [&](const Bounds3f& box) { add_box(clipper, box); });
      },
      scene.shapes[static_cast<std::size_t>(instance.shape)]);
}

SeenParts seen_parts(const Scene& scene, const Instance& instance, const ResolvedScene& resolved,
                     const Affine3f& frame_from_world, const ConvexRegion& region) {
  SeenParts parts;
  visit_seen(scene, instance, resolved, frame_from_world, region, [&](std::span<const Vec3f> polygon) {
    for (const Vec3f& p : polygon) {
      parts.bounds.add(p);
      if (p.z < 0.0f) parts.tangent = glm::max(parts.tangent, glm::abs(Vec2f(p)) / -p.z);
    }
  });
  return parts;
}

}  // namespace lippmann
