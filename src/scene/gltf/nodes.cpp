#include "scene/gltf/nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lippmann::gltf {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Affine3f affine(const std::vector<double>& m, const std::string& where, const Report& report) {
  constexpr double kTolerance = 1e-5;  // exporters multiply matrices in float precision, so the last row is only nearly 0 0 0 1
  if (std::abs(m[3]) + std::abs(m[7]) + std::abs(m[11]) + std::abs(m[15] - 1.0) > kTolerance)
    report.fail(where, "is not an affine transform", "a matrix whose last row is 0 0 0 1");
  return {Mat3f(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]), Vec3f(m[12], m[13], m[14])};
}

Node read_node(Value from, const std::string& where, const Report& report) {
  Node node;
  node.name = from["name"].text();
  if (const Value matrix = from["matrix"]) {
    node.matrix = affine(matrix.numbers(), where + ".matrix", report);
    return node;
  }
  node.local.translation = from["translation"].vector(Vec3f(0.0f));
  node.local.scale = from["scale"].vector(Vec3f(1.0f));
  if (from["rotation"]) {
    const Vec4f q = from["rotation"].vector(Vec4f(0.0f));
    const Quatf rotation(q.w, q.x, q.y, q.z);
    const float length = glm::length(rotation);
    if (!(length > 1e-6f) || !std::isfinite(length)) report.fail(where + ".rotation", "is not a unit quaternion");
    node.local.rotation = rotation / length;
  }
  return node;
}

Affine3d exact_transform(Value from) {
  if (const std::vector<double> m = from["matrix"].numbers(); !m.empty())
    return {glm::dmat3(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]), Vec3d(m[12], m[13], m[14])};
  const auto vector = [](const std::vector<double>& v, double otherwise) {
    return v.empty() ? Vec3d(otherwise) : Vec3d(v[0], v[1], v[2]);
  };
  const std::vector<double> q = from["rotation"].numbers();
  const glm::dquat rotation = q.empty() ? glm::dquat(1.0, 0.0, 0.0, 0.0) : glm::dquat(q[3], q[0], q[1], q[2]);
  const glm::dmat3 r = glm::mat3_cast(glm::normalize(rotation));
  const Vec3d scale = vector(from["scale"].numbers(), 1.0);
  return {{scale.x * r[0], scale.y * r[1], scale.z * r[2]}, vector(from["translation"].numbers(), 0.0)};
}

/// Returns the parent of each node; -1: none. Throws Error if a node has two parents. The result may still contain cycles.
std::vector<int> find_parents(Value nodes, const Report& report) {
  std::vector<int> parents(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const int child : nodes.at(i)["children"].indices()) {
      int& parent = parents[at(child)];
      if (parent >= 0)
        report.fail(element("nodes", at(child)), fmt::format("has two parents, nodes[{}] and nodes[{}]", parent, i));
      parent = static_cast<int>(i);
    }
  return parents;
}

std::vector<int> tops_of(const std::vector<int>& parents) {
  std::vector<int> tops;
  for (std::size_t i = 0; i < parents.size(); ++i)
    if (parents[i] < 0) tops.push_back(static_cast<int>(i));
  return tops;
}

/// Returns `roots` and all nodes below them, depth first. The function is iterative because hierarchies may be arbitrarily
/// deep.
std::vector<int> preorder(Value nodes, const std::vector<int>& roots) {
  std::vector<int> order, stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    order.push_back(node);
    const std::vector<int> children = nodes.at(at(node))["children"].indices();
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
  return order;
}

void check_cycles(Value nodes, const std::vector<int>& parents, const Report& report) {
  std::vector<bool> reached(parents.size(), false);
  for (const int node : preorder(nodes, tops_of(parents))) reached[at(node)] = true;
  const auto unreached = std::find(reached.begin(), reached.end(), false);
  if (unreached != reached.end())
    report.fail(element("nodes", static_cast<std::size_t>(unreached - reached.begin())),
                "is part of or below a cycle of nodes");
}

std::vector<bool> below_listed(Value nodes, const std::vector<int>& listed, const std::vector<int>& parents) {
  std::vector<bool> in_scene(parents.size(), false), below(parents.size(), false);
  for (const int node : listed) in_scene[at(node)] = true;
  for (const int node : preorder(nodes, tops_of(parents)))
    if (const int parent = parents[at(node)]; parent >= 0 && in_scene[at(parent)]) in_scene[at(node)] = below[at(node)] = true;
  return below;
}

/// Returns the roots of a scene that lists the nodes `listed`. The specification only allows root nodes in this list. A listed
/// node with a listed ancestor is part of the scene through this ancestor. Any other listed node becomes a root, without the
/// transforms of its parents.
std::vector<int> roots_among(const std::vector<int>& listed, const std::vector<int>& parents, const std::string& where,
                             Document& document) {
  const auto child = std::find_if(listed.begin(), listed.end(), [&](int node) { return parents[at(node)] >= 0; });
  if (child == listed.end()) return listed;
  document.report.warn(
      fmt::format("{} lists nodes[{}], which is not a root but a child of nodes[{}]: it is shown once, "
                  "below its parent if that is in the scene",
                  where, *child, parents[at(*child)]));
  const std::vector<bool> below = below_listed(document.root["nodes"], listed, parents);
  std::vector<int> roots;
  std::copy_if(listed.begin(), listed.end(), std::back_inserter(roots), [&](int node) { return !below[at(node)]; });
  return roots;
}

std::vector<int> roots_of(Document& document, const std::vector<int>& parents) {
  const Value scenes = document.root["scenes"];
  if (scenes.size() == 0) return tops_of(parents);
  const std::size_t chosen = chosen_scene(document);
  if (scenes.size() > 1)
    document.report.warn(fmt::format("only the default scene, scenes[{}] of {}, is read", chosen, scenes.size()));
  return roots_among(scenes.at(chosen)["nodes"].indices(), parents, element("scenes", chosen), document);
}

/// Returns whether a node, and thus all its descendants, is invisible. Based on: Khronos Group, "KHR_node_visibility", 2025.
bool hides_itself(Value node) { return !node.extension("KHR_node_visibility")["visible"].flag(true); }

}  // namespace

std::size_t chosen_scene(const Document& document) { return document.root["scene"].count(); }

NodeMap read_nodes(Document& document, Scene& scene) {
  const Value nodes = document.root["nodes"];
  const std::vector<int> parents = find_parents(nodes, document.report);
  check_cycles(nodes, parents, document.report);

  NodeMap map;
  map.file_node = preorder(nodes, roots_of(document, parents));
  map.scene_node.assign(nodes.size(), -1);
  for (const int file_node : map.file_node) {
    map.scene_node[at(file_node)] = static_cast<int>(scene.nodes.size());
    const Value from = nodes.at(at(file_node));
    Node node = read_node(from, element("nodes", at(file_node)), document.report);
    map.parent_from_node.push_back(exact_transform(from));
    const int parent = parents[at(file_node)];
    node.parent = parent < 0 ? -1 : map.scene_node[at(parent)];
    map.hidden.push_back(hides_itself(from) || (node.parent >= 0 && map.hidden[at(node.parent)]));
    scene.nodes.push_back(std::move(node));
  }
  return map;
}

}  // namespace lippmann::gltf
