#include "lippmann/stage/camera_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/random.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/timeline.hpp"
#include "stage/subject.hpp"

namespace lippmann {
namespace {

constexpr std::array<std::string_view, 3> kCameraPathNames{"sphere", "hemisphere", "circle"};

Bounds3f still_subject_bounds(const Scene& scene) {
  const Subject subject = find_subject(scene);
  const ResolvedScene resolved = evaluate(scene, 0.0);
  Bounds3f bounds;
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (subject.contains(i)) bounds.add(bounds_of_part(scene, subject, i, resolved));
  return bounds;
}

void hold_still(Scene& scene) {
  // The nodes of `loose` have no parents, so world and local transforms are equal.
  Scene loose;
  loose.nodes = scene.nodes;
  loose.timeline = scene.timeline;
  for (Node& node : loose.nodes) node.parent = -1;
  const ResolvedScene local = evaluate(loose, 0.0);
  for (const NodeAnimation& animation : scene.timeline.animations) {
    const auto node = static_cast<std::size_t>(animation.node);
    scene.nodes[node].matrix = local.world_from_node[node];
    if (!local.morph_weights.empty()) scene.nodes[node].morph_weights = local.morph_weights[node];
  }
  scene.timeline.animations.clear();
}

Quatf facing(const Vec3d& direction) {
  const Vec3d right = glm::normalize(glm::cross(Vec3d(0.0, 1.0, 0.0), direction));
  return Quatf(glm::quat_cast(glm::dmat3(right, glm::cross(direction, right), direction)));
}

}  // namespace

CameraSet read_camera_set(const std::string& text, const std::string& where) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const auto path = std::find(kCameraPathNames.begin(), kCameraPathNames.end(), text.substr(0, colon));
  int count = 0;
  const char *begin = text.data() + std::min(colon + 1, text.size()), *end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(begin, end, count);
  const bool is_count = problem == std::errc() && stop == end && count >= 1 && count <= kMostCameras;
  if (path == kCameraPathNames.end() || !is_count)
    throw usage_error(where, "cannot read '" + text + "' as cameras around the scene",
                      fmt::format("sphere:N, hemisphere:N or circle:N, with 1 to {} cameras", kMostCameras));
  return {static_cast<CameraPath>(path - kCameraPathNames.begin()), count};
}

std::string write_camera_set(const CameraSet& set) {
  return fmt::format("{}:{}", kCameraPathNames[static_cast<std::size_t>(set.path)], set.count);
}

std::vector<Vec3d> camera_directions(const CameraSet& set) {
  constexpr double kGoldenAngle = std::numbers::pi * 0.7639320225002102;  // pi (3 - sqrt 5)
  constexpr double kCircleHeight = 0.3420201433256687;                    // sin 20 degrees
  std::vector<Vec3d> directions;
  for (int i = 0; i < set.count; ++i) {
    const double share = (i + 0.5) / set.count;
    const bool is_circle = set.path == CameraPath::kCircle;
    const double y = is_circle ? kCircleHeight : set.path == CameraPath::kSphere ? 1.0 - 2.0 * share : 1.0 - share;
    const double turn = is_circle ? 2.0 * std::numbers::pi * i / set.count : kGoldenAngle * i;
    const double level = std::sqrt(1.0 - y * y);
    directions.emplace_back(level * std::sin(turn), y, level * std::cos(turn));
  }
  return directions;
}

std::vector<bool> test_cameras(int count, std::uint32_t seed) {
  constexpr int kOneOf = 8;
  std::vector<std::uint32_t> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(hash(seed, a), a) < std::pair(hash(seed, b), b); });
  std::vector<bool> is_test(order.size());
  const int tests = count < 2 ? 0 : std::max(1, count / kOneOf);
  for (int i = 0; i < tests; ++i) is_test[order[static_cast<std::size_t>(i)]] = true;
  return is_test;
}

void surround_with_cameras(Scene& scene, const CameraSet& set) {
  constexpr float kUsualFov = radians(45.0f), kMarginAround = 1.05f;
  hold_still(scene);
  const Bounds3f bounds = still_subject_bounds(scene);
  if (bounds.empty()) throw Error("scene", "has nothing finite that cameras could look at", "a scene with shapes");
  Camera camera;
  camera.name = write_camera_set(set);
  const bool has_angle = !scene.cameras.empty() && !(scene.cameras.front().orthographic_height > 0.0f);
  camera.vertical_fov = has_angle ? scene.cameras.front().vertical_fov : kUsualFov;
  const float radius = std::max(0.5f * diagonal(bounds), 1e-6f);
  camera.focus_distance = kMarginAround * radius / std::sin(0.5f * camera.vertical_fov);
  camera.node = static_cast<int>(scene.nodes.size());
  NodeAnimation path;
  path.node = camera.node;
  path.translation.interpolation = path.rotation.interpolation = Interpolation::kStep;
  Timeline& timeline = scene.timeline;
  for (const Vec3d& direction : camera_directions(set)) {
    const double time = timeline.time(static_cast<int>(path.translation.times.size()));
    path.translation.times.push_back(time), path.rotation.times.push_back(time);
    path.translation.values.push_back(bounds.center() + camera.focus_distance * Vec3f(direction));
    path.rotation.values.push_back(facing(direction));
  }
  Node node;
  node.name = camera.name;
  node.local.translation = path.translation.values.front();
  node.local.rotation = path.rotation.values.front();
  scene.nodes.push_back(std::move(node));
  timeline.animations = {std::move(path)};
  timeline.frame_count = set.count;
  scene.cameras = {std::move(camera)};
  scene.display.reset();
}

}  // namespace lippmann
