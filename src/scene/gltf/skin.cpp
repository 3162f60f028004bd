// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 3.7.3 "Skins": a vertex stands at
// sum_i w_i J_i B_i v, with J the joint's world transform and B its inverse bind matrix; the transform of the node that shows
// the mesh does not take part.
#include "scene/gltf/skin.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scene/gltf/accessor.hpp"

namespace lippmann::gltf {
namespace {

struct Influences {
  std::vector<Joints> joints;
  std::vector<Vec4f> weights;
};

Affine3f affine(const glm::mat4& m) { return {Mat3f(m), Vec3f(m[3])}; }

/// J B of every joint.
std::vector<Affine3f> joint_transforms(Document& document, int skin_index, const NodeMap& nodes, const ResolvedScene& rest) {
  const tinygltf::Skin& skin = document.model.skins[static_cast<std::size_t>(skin_index)];
  const std::string where = element("skins", static_cast<std::size_t>(skin_index));
  std::vector<glm::mat4> inverse_bind;
  if (skin.inverseBindMatrices >= 0) inverse_bind = unpack<glm::mat4>(document, skin.inverseBindMatrices);
  if (!inverse_bind.empty() && inverse_bind.size() < skin.joints.size())
    document.report.fail(where,
                         fmt::format("has {} joints, but {} inverse bind matrices", skin.joints.size(), inverse_bind.size()));

  std::vector<Affine3f> transforms;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const int node = nodes.scene_node[static_cast<std::size_t>(skin.joints[i])];
    if (node < 0)
      document.report.fail(where, fmt::format("has the joint nodes[{}], which is not in the scene", skin.joints[i]));
    transforms.push_back(inverse_bind.empty() ? rest.of(node) : rest.of(node) * affine(inverse_bind[i]));
  }
  return transforms;
}

/// All sets JOINTS_0 and WEIGHTS_0, JOINTS_1 ...; each has one entry per vertex.
std::vector<Influences> read_influences(Document& document, PrimitiveId id, std::size_t vertices, std::size_t joints) {
  std::vector<Influences> sets;
  const auto& attributes = primitive_of(document, id).attributes;
  for (;;) {
    const auto joint = attributes.find(fmt::format("JOINTS_{}", sets.size()));
    const auto weight = attributes.find(fmt::format("WEIGHTS_{}", sets.size()));
    if (joint == attributes.end() || weight == attributes.end()) return sets;
    Influences set{unpack_unsigned<Joints>(document, joint->second), unpack<Vec4f>(document, weight->second)};
    if (set.joints.size() != vertices || set.weights.size() != vertices)
      document.report.fail(element(id), fmt::format("has {} positions, but {} joints and {} weights", vertices,
                                                    set.joints.size(), set.weights.size()));
    for (std::size_t i = 0; i < vertices; ++i)
      for (int k = 0; k < 4; ++k)
        if (set.weights[i][k] != 0.0f && set.joints[i][k] >= joints)
          document.report.fail(element(id), fmt::format("vertex {} hangs on joint {}", i, set.joints[i][k]),
                               fmt::format("0 to {}", joints - 1));
    sets.push_back(std::move(set));
  }
}

/// The blend of the joints' transforms; weights that do not add up to one are scaled. Without any weight, the first joint's.
Affine3f blend(const std::vector<Influences>& sets, std::size_t vertex, const std::vector<Affine3f>& transforms) {
  Affine3f sum{Mat3f(0.0f), Vec3f(0.0f)};
  float total = 0.0f;
  for (const Influences& set : sets)
    for (int k = 0; k < 4; ++k) {
      const float weight = set.weights[vertex][k];
      if (weight == 0.0f) continue;
      const Affine3f& t = transforms[set.joints[vertex][k]];
      sum.linear += weight * t.linear;
      sum.translation += weight * t.translation;
      total += weight;
    }
  return total > 0.0f ? Affine3f{sum.linear / total, sum.translation / total} : transforms.front();
}

Vec3f unit_or(Vec3f v, Vec3f otherwise) {
  const float length = glm::length(v);
  return length > 0.0f && std::isfinite(length) ? v / length : otherwise;
}

}  // namespace

void pose_at_rest(Document& document, PrimitiveId id, int skin, const NodeMap& nodes, const ResolvedScene& rest, Mesh& mesh) {
  const std::vector<Affine3f> transforms = joint_transforms(document, skin, nodes, rest);
  if (transforms.empty()) return;
  const std::vector<Influences> sets = read_influences(document, id, mesh.positions.size(), transforms.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Affine3f world_from_vertex = blend(sets, i, transforms);
    mesh.positions[i] = transform_point(world_from_vertex, mesh.positions[i]);
    if (!std::isfinite(glm::dot(mesh.positions[i], Vec3f(1.0f))))
      document.report.fail(element(id), fmt::format("vertex {} is posed infinitely far away", i));
    if (!mesh.normals.empty()) mesh.normals[i] = unit_or(transform_normal(world_from_vertex, mesh.normals[i]), mesh.normals[i]);
  }
}

}  // namespace lippmann::gltf
