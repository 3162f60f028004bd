#include "scene/gltf/skin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/gltf/accessor.hpp"

namespace lippmann::gltf {
namespace {

Affine3f affine(const glm::mat4& m) { return {Mat3f(m), Vec3f(m[3])}; }

std::vector<Affine3f> read_inverse_binds(Document& document, Value skin, const std::string& where) {
  std::vector<Affine3f> matrices(skin["joints"].size());
  if (!skin["inverseBindMatrices"]) return matrices;
  const std::vector<glm::mat4> read = unpack<glm::mat4>(document, skin["inverseBindMatrices"].index());
  if (read.size() < matrices.size())
    document.report.fail(where, fmt::format("has {} joints, but {} inverse bind matrices", matrices.size(), read.size()));
  for (std::size_t i = 0; i < matrices.size(); ++i) matrices[i] = affine(read[i]);
  return matrices;
}

struct Influences {
  std::vector<Joints> joints;
  std::vector<Vec4f> weights;
};

std::vector<Influences> read_influences(Document& document, PrimitiveId id, std::size_t vertices, std::size_t joints) {
  std::vector<Influences> sets;
  const Value primitive = primitive_of(document, id);
  for (;;) {
    const int joint = attribute(primitive, fmt::format("JOINTS_{}", sets.size()));
    const int weight = attribute(primitive, fmt::format("WEIGHTS_{}", sets.size()));
    if (joint < 0 || weight < 0) return sets;
    Influences set{unpack_unsigned<Joints>(document, joint), unpack<Vec4f>(document, weight)};
    if (set.joints.size() != vertices || set.weights.size() != vertices)
      document.report.fail(element(id), fmt::format("has {} positions, but {} joints and {} weights", vertices,
                                                    set.joints.size(), set.weights.size()));
    for (std::size_t i = 0; i < vertices; ++i)
      for (int k = 0; k < 4; ++k)
        if (set.weights[i][k] != 0.0f && set.joints[i][k] >= joints)
          document.report.fail(element(id), fmt::format("vertex {} refers to joint {}", i, set.joints[i][k]),
                               fmt::format("0 to {}", joints - 1));
    sets.push_back(std::move(set));
  }
}

}  // namespace

int SkinReader::read(int index) {
  const auto [known, is_new] = known_.try_emplace(index, -1);
  if (!is_new) return known->second;
  const Value from = document_.at("skins", index);
  const std::vector<int> joints = from["joints"].indices();
  const std::string where = element("skins", static_cast<std::size_t>(index));
  if (joints.empty()) return -1;
  Skin skin{from["name"].text(), {}, read_inverse_binds(document_, from, where)};
  for (const int joint : joints) {
    skin.joints.push_back(nodes_.scene_node[static_cast<std::size_t>(joint)]);
    if (skin.joints.back() < 0)
      document_.report.fail(where, fmt::format("has the joint nodes[{}], which is not in the scene", joint));
  }
  known->second = static_cast<int>(scene_.skins.size());
  scene_.skins.push_back(std::move(skin));
  return known->second;
}

void read_skin_weights(Document& document, PrimitiveId id, std::size_t joints, Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  const std::vector<Influences> sets = read_influences(document, id, vertices, joints);
  const std::size_t per_vertex = sets.empty() ? 1 : 4 * sets.size();
  document.unpacked.spend(vertices * per_vertex, sizeof(std::uint32_t) + sizeof(float), element(id), document.report);
  SkinWeights& skin = mesh.skin;
  skin.per_vertex = static_cast<int>(per_vertex);
  skin.joints.resize(vertices * per_vertex);
  skin.weights.resize(vertices * per_vertex);
  for (std::size_t i = 0; i < vertices; ++i) {
    float total = 0.0f;
    for (std::size_t k = 0; k < 4 * sets.size(); ++k) {
      const float weight = std::max(sets[k / 4].weights[i][static_cast<int>(k % 4)], 0.0f);
      skin.weights[i * per_vertex + k] = weight;
      if (weight > 0.0f) skin.joints[i * per_vertex + k] = sets[k / 4].joints[i][static_cast<int>(k % 4)];
      total += weight;
    }
    const bool none = !(total > 0.0f) || total > 1e30f;
    for (std::size_t k = 0; k < per_vertex; ++k)
      skin.weights[i * per_vertex + k] = none ? 0.0f : skin.weights[i * per_vertex + k] / total;
    if (none) skin.joints[i * per_vertex] = 0, skin.weights[i * per_vertex] = 1.0f;
  }
}

void read_targets(Document& document, PrimitiveId id, Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  const Value targets = primitive_of(document, id)["targets"];
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto read = [&](const char* name) {
      return read_per_vertex<Vec3f>(document, id, targets.at(i)[name].index(), name, vertices);
    };
    MorphTarget target{read("POSITION"), {}, {}};
    if (!mesh.normals.empty()) target.normals = read("NORMAL");
    if (!mesh.tangents.empty()) target.tangents = read("TANGENT");
    document.unpacked.spend(1, sizeof(MorphTarget), element(id), document.report);
    mesh.targets.push_back(std::move(target));
  }
}

std::vector<float> read_morph_weights(Document& document, int file_node) {
  const Value node = document.at("nodes", file_node);
  const int index = node["mesh"].index();
  if (index < 0) return {};
  const Value mesh = document.at("meshes", index), primitives = mesh["primitives"];
  const std::size_t targets = primitives.size() == 0 ? 0 : primitives.at(0)["targets"].size();
  for (std::size_t i = 0; i < primitives.size(); ++i)
    if (const std::size_t count = primitives.at(i)["targets"].size(); count != targets)
      document.report.fail(element({index, static_cast<int>(i)}),
                           fmt::format("has {} morph targets, the mesh's first primitive {}", count, targets));
  const std::vector<double> given = (node["weights"].size() > 0 ? node : mesh)["weights"].numbers();
  if (!given.empty() && given.size() != targets)
    document.report.fail(element("nodes", static_cast<std::size_t>(file_node)),
                         fmt::format("has {} weights for {} morph targets", given.size(), targets));
  document.unpacked.spend(targets, sizeof(float), element("nodes", static_cast<std::size_t>(file_node)), document.report);
  std::vector<float> weights(given.begin(), given.end());
  weights.resize(targets, 0.0f);
  return weights;
}

}  // namespace lippmann::gltf
