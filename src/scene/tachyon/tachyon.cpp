#include "scene/tachyon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "lippmann/scene/timeline.hpp"
#include "scene/tachyon/camera_path.hpp"
#include "scene/tachyon/parser.hpp"

namespace lippmann {
namespace tachyon {
namespace {

constexpr double kViewerAngle = 45.0 * std::numbers::pi / 180.0;

void add_camera(Scene& scene, const CameraRecord& record) {
  Node node;
  node.name = "camera";
  node.local = node_of(record.pose);
  Camera camera = camera_of(record, scene.resolution);
  camera.node = static_cast<int>(scene.nodes.size());
  scene.nodes.push_back(std::move(node));
  scene.cameras.push_back(std::move(camera));
}

/// Converts the gradient of SKY_ORTHO_PLANE, which depends on the heights where rays start, to a gradient over ray directions.
Background over_directions(Background plane, const CameraRecord& camera, const Vec3d& origin) {
  const Vec3d center = Vec3d(camera.pose.center) + origin;
  const double middle = glm::dot(Vec3d(center.x, center.y, -center.z), Vec3d(plane.up));
  const double distance = 0.5 / camera.zoom / std::tan(0.5 * kViewerAngle);
  const auto sine = [&](float height) {
    const double above = static_cast<double>(height) - middle;
    return static_cast<float>(above / std::hypot(above, distance));
  };
  plane.horizon_at = sine(plane.horizon_at), plane.zenith_at = sine(plane.zenith_at);
  return plane;
}

Background background_of(const ParserState& state, const Vec3d& origin) {
  if (!state.gradient) return state.background;
  if (!state.gradient_is_plane || !state.camera.is_orthographic) return *state.gradient;
  const Background sky = over_directions(*state.gradient, state.camera, origin);
  return sky.horizon_at == sky.zenith_at ? *state.gradient : sky;
}

/// Warns that the scene is orthographic. Also warns if the picture shows only a small part of the scene, as in files that use
/// pixels as units.
void warn_about_orthographic(const Scene& scene, const std::string& name, const Context& context) {
  constexpr float kSmall = 0.05f, kLeastZoom = 1e-3f;
  const float height = scene.cameras.front().orthographic_height;
  context.warning(
      fmt::format("{}: PROJECTION ORTHOGRAPHIC sets the height of the display's plane; viewers see it in perspective.", name));
  const Bounds3f bounds = finite_bounds(scene, evaluate(scene, 0.0));
  const float size = bounds.empty() ? 0.0f : glm::length(bounds.size());
  if (!(height < kSmall * size)) return;
  const float zoom = std::max(kLeastZoom, 0.8f * height / size);
  context.warning(
      fmt::format("{}: its camera's ZOOM shows {:.3g} units of a scene that is {:.3g} units large, as Tachyon does; "
                  "`zoom` {:.1g} shows {} of it.",
                  name, height, size, zoom, zoom > kLeastZoom ? "all" : "more"));
}

}  // namespace

Scene read_scene(Lexer& lexer, SceneFolder& folder, const Context& context, double frames_per_second) {
  ParserState state(folder, context);
  parse_scene(lexer, state);
  if (const int count = state.builder.left_out(); count > 0)
    context.warning(fmt::format("{}: {} shapes without extent are left out.", lexer.name(), count));
  state.left_out.warn(context, "effect", "effects");
  Scene scene = state.builder.take();
  apply_shader_mode(state.shading, scene);
  scene.background = background_of(state, lexer.origin());
  scene.encoding = Encoding::kTachyonTruncate;
  scene.max_depth = std::max(state.camera.ray_depth, 1);
  scene.resolution = state.resolution;
  scene.timeline.frames_per_second = frames_per_second;
  add_camera(scene, state.camera);
  if (state.camera.is_orthographic) warn_about_orthographic(scene, lexer.name(), context);
  return scene;
}

void animate_camera(Scene& scene, Lexer& path) {
  const std::vector<CameraPose> poses = parse_camera_path(path);
  const int node = scene.cameras.front().node;
  scene.nodes[static_cast<std::size_t>(node)].local = node_of(poses.front());
  animate(scene.timeline, node, poses);
}

}  // namespace tachyon

Scene load_tachyon(const std::filesystem::path& path, const std::optional<std::filesystem::path>& camera_path,
                   const Context& context, double frames_per_second, const std::filesystem::path& asset_root,
                   const Vec3d& origin) {
  const Vec3d in_file(origin.x, origin.y, -origin.z);  // Tachyon's coordinates are mirrored (handedness.hpp)
  tachyon::SceneFolder folder(path, asset_root);
  Lexer lexer(path.string(), folder.read_text(path, path.string()));
  lexer.set_origin(in_file);
  Scene scene = tachyon::read_scene(lexer, folder, context, frames_per_second);
  scene.name = path.stem().string();
  scene.origin = origin;
  if (camera_path) {
    tachyon::SceneFolder path_folder(*camera_path);
    Lexer poses(camera_path->string(), path_folder.read_text(*camera_path, camera_path->string()));
    poses.set_origin(in_file);
    tachyon::animate_camera(scene, poses);
  }
  return scene;
}

}  // namespace lippmann
