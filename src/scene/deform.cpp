// Based on: Khronos Group, "glTF 2.0 Specification", 2021, sections 3.7.2.2 "Morph Targets" and 3.7.3 "Skins".
// 1. The position of a vertex is the base position plus the sum of weight * offset over the morph targets.
// 2. The skin moves it to v' = sum_i w_i J_i B_i v. J_i is the world transform of joint i, and B_i is its inverse bind matrix.
//    The transform of the mesh's node is ignored.
//
// Normals are transformed by the cofactor matrix of sum_i w_i J_i B_i, which equals the inverse transpose up to scale but also
// exists for singular matrices.
#include "scene/deform.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann {
namespace {

const Mesh& mesh_of(const Scene& scene, const Instance& instance) {
  return std::get<Mesh>(scene.shapes[static_cast<std::size_t>(instance.shape)]);
}

Mat3f cofactors(const Mat3f& m) { return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])}; }

Vec3f unit_or(Vec3f v, Vec3f otherwise) {
  const float length = glm::length(v);
  return length > 0.0f && std::isfinite(length) ? v / length : otherwise;
}

float within_reach(float x) { return x <= MeshPose::kReach ? std::max(x, -MeshPose::kReach) : MeshPose::kReach; }
Vec3f within_reach(Vec3f p) { return {within_reach(p.x), within_reach(p.y), within_reach(p.z)}; }

std::vector<Affine3f> joint_transforms(const Skin& skin, const ResolvedScene& resolved) {
  std::vector<Affine3f> transforms;
  transforms.reserve(skin.joints.size());
  for (std::size_t i = 0; i < skin.joints.size(); ++i)
    transforms.push_back(resolved.of(skin.joints[i]) * skin.joint_from_mesh[i]);
  return transforms;
}

}  // namespace

bool is_posed(const Scene& scene, const Instance& instance) {
  const Mesh* mesh = std::get_if<Mesh>(&scene.shapes[static_cast<std::size_t>(instance.shape)]);
  return mesh && (instance.skin >= 0 || !mesh->targets.empty());
}

std::vector<bool> moving_instances(const Scene& scene) {
  const std::vector<bool> node_moves = moving_nodes(scene), weights_change = morphing_nodes(scene);
  const auto is_set = [](const std::vector<bool>& of_node, int node) {
    return node >= 0 && of_node[static_cast<std::size_t>(node)];
  };
  std::vector<bool> moves;
  moves.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances) {
    bool any = is_posed(scene, instance) && is_set(weights_change, instance.node);
    if (instance.skin < 0) {
      any = any || is_set(node_moves, instance.node);
    } else {
      for (const int joint : scene.skins[static_cast<std::size_t>(instance.skin)].joints)
        any = any || is_set(node_moves, joint);
    }
    moves.push_back(any);
  }
  return moves;
}

MeshPose::MeshPose(const Scene& scene, const Instance& instance, const ResolvedScene& resolved)
    : mesh_(mesh_of(scene, instance)), has_skin_(instance.skin >= 0) {
  for (std::size_t i = 0; i < mesh_.targets.size(); ++i) {
    const float weight = resolved.morph_weights[static_cast<std::size_t>(instance.node)][i];
    if (weight != 0.0f) targets_.push_back({&mesh_.targets[i], weight});
  }
  if (has_skin_)
    world_from_mesh_ = joint_transforms(scene.skins[static_cast<std::size_t>(instance.skin)], resolved);
  else
    world_from_mesh_ = {resolved.of(instance.node)};
}

Affine3f MeshPose::world_from_vertex(std::size_t vertex) const {
  if (!has_skin_) return world_from_mesh_.front();
  Affine3f sum{Mat3f(0.0f), Vec3f(0.0f)};
  const auto count = static_cast<std::size_t>(mesh_.skin.per_vertex);
  for (std::size_t i = vertex * count; i < (vertex + 1) * count; ++i) {
    const float weight = mesh_.skin.weights[i];
    if (weight == 0.0f) continue;
    const Affine3f& joint = world_from_mesh_[mesh_.skin.joints[i]];
    sum.linear += weight * joint.linear;
    sum.translation += weight * joint.translation;
  }
  return sum;
}

Vec3f MeshPose::morphed_position(std::size_t vertex) const {
  Vec3f p = mesh_.positions[vertex];
  for (const Weighted& w : targets_)
    if (!w.target->positions.empty()) p += w.weight * w.target->positions[vertex];
  return p;
}

Vec3f MeshPose::position(std::size_t vertex) const {
  return within_reach(transform_point(world_from_vertex(vertex), morphed_position(vertex)));
}

PosedVertex MeshPose::vertex(std::size_t vertex) const {
  const Affine3f world = world_from_vertex(vertex);
  PosedVertex posed;
  posed.position = within_reach(transform_point(world, morphed_position(vertex)));
  if (!mesh_.normals.empty()) {
    Vec3f n = mesh_.normals[vertex];
    for (const Weighted& w : targets_)
      if (!w.target->normals.empty()) n += w.weight * w.target->normals[vertex];
    posed.normal = unit_or(cofactors(world.linear) * n, mesh_.normals[vertex]);
  }
  if (!mesh_.tangents.empty()) {
    Vec3f t(mesh_.tangents[vertex]);
    for (const Weighted& w : targets_)
      if (!w.target->tangents.empty()) t += w.weight * w.target->tangents[vertex];
    posed.tangent = Vec4f(unit_or(world.linear * t, Vec3f(mesh_.tangents[vertex])), mesh_.tangents[vertex].w);
  }
  return posed;
}

bool MeshPose::mirrors() const { return glm::determinant(world_from_mesh_.front().linear) < 0.0f; }

}  // namespace lippmann
