#include "lippmann/stage/choose_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kNoCamera = static_cast<std::size_t>(-1);

/// A name has precedence over an index, because a camera may be named "1".
std::size_t find_camera(const std::vector<std::string>& names, const std::string& wanted) {
  const auto named = std::find(names.begin(), names.end(), wanted);
  if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
  std::size_t index = kNoCamera;
  const char* const end = wanted.data() + wanted.size();
  const auto [rest, failure] = std::from_chars(wanted.data(), end, index);
  return failure == std::errc{} && rest == end && index < names.size() ? index : kNoCamera;
}

Error no_such_camera(const std::vector<std::string>& names, const std::string& wanted) {
  if (names.empty()) return usage_error("camera", "the scene has no cameras", "no `camera`");
  const std::string hint = did_you_mean(wanted, std::vector<std::string_view>(names.begin(), names.end()));
  return usage_error("camera", fmt::format("there is no camera {}{}", shown(wanted), hint), list_cameras(names));
}

Quatf upright(UpAxis up) {
  constexpr float kHalf = 0.70710678f;
  switch (up) {
    case UpAxis::kY:
      return {1.0f, 0.0f, 0.0f, 0.0f};
    case UpAxis::kX:
      return {kHalf, 0.0f, 0.0f, kHalf};
    case UpAxis::kZ:
      return {kHalf, -kHalf, 0.0f, 0.0f};
    case UpAxis::kMinusX:
      return {kHalf, 0.0f, 0.0f, -kHalf};
    case UpAxis::kMinusY:
      return {0.0f, 1.0f, 0.0f, 0.0f};
    case UpAxis::kMinusZ:
      return {kHalf, kHalf, 0.0f, 0.0f};
  }
  return {1.0f, 0.0f, 0.0f, 0.0f};
}

/// Makes `root` node 0 and the parent of all root nodes, and of instances, lights and cameras without a node (-1).
void insert_root(Scene& scene, Node root) {
  for (Node& node : scene.nodes) ++node.parent;
  for (Instance& instance : scene.instances) ++instance.node;
  for (Light& light : scene.lights) ++light.node;
  for (Camera& camera : scene.cameras) ++camera.node;
  for (Skin& skin : scene.skins)
    for (int& joint : skin.joints) ++joint;
  for (NodeAnimation& animation : scene.timeline.animations) ++animation.node;
  if (scene.display) ++scene.display->node;
  scene.nodes.insert(scene.nodes.begin(), std::move(root));
}

}  // namespace

std::vector<std::string> camera_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Camera& camera : scene.cameras) names.push_back(camera.name);
  return names;
}

std::string list_cameras(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += names[i].empty() ? fmt::format("{}{} (without a name)", i == 0 ? "" : ", ", i)
                             : fmt::format("{}{} ({})", i == 0 ? "" : ", ", printable(names[i]), i);
  return text;
}

void choose_camera(Scene& scene, const std::string& wanted) {
  if (wanted.empty()) return;
  const std::vector<std::string> names = camera_names(scene);
  const std::size_t chosen = find_camera(names, wanted);
  if (chosen == kNoCamera) throw no_such_camera(names, wanted);
  choose_camera(scene, chosen);
}

void choose_camera(Scene& scene, std::size_t index) {
  if (index >= scene.cameras.size()) throw no_such_camera(camera_names(scene), std::to_string(index));
  const auto at = scene.cameras.begin() + static_cast<std::ptrdiff_t>(index);
  std::rotate(scene.cameras.begin(), at, at + 1);
  scene.display.reset();
}

void turn_upright(Scene& scene, UpAxis up) {
  if (up == UpAxis::kY) return;
  Node root;
  root.name = "upright";
  root.local.rotation = upright(up);
  insert_root(scene, std::move(root));
  scene.background.up = glm::normalize(upright(up) * scene.background.up);
  const Mat3f turn = glm::mat3_cast(upright(up));
  const glm::dmat3 exact{glm::round(turn[0]), glm::round(turn[1]), glm::round(turn[2])};
  scene.origin = exact * scene.origin;
}

}  // namespace lippmann
