#include "scene/tachyon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/tachyon/camera_path.hpp"
#include "scene/tachyon/parser.hpp"

namespace lippmann {
namespace tachyon {
namespace {

/// Puts the camera on a node of its own.
void add_camera(Scene& scene, const CameraRecord& record) {
  Node node;
  node.name = "camera";
  node.local = node_of(record.pose);
  Camera camera = camera_of(record, scene.resolution);
  camera.node = static_cast<int>(scene.nodes.size());
  scene.nodes.push_back(std::move(node));
  scene.cameras.push_back(std::move(camera));
}

}  // namespace

Scene read_scene(Lexer& lexer, SceneFolder& folder, const Context& context, double frames_per_second) {
  ParserState state(folder, context);
  parse_scene(lexer, state);
  if (const int count = state.builder.left_out(); count > 0)
    context.warning(fmt::format("{}: {} shapes without extent are left out.", lexer.name(), count));
  Scene scene = state.builder.take();
  scene.background = state.gradient.value_or(state.background);
  scene.encoding = Encoding::kTachyonTruncate;
  scene.max_depth = std::max(state.camera.ray_depth, 1);
  scene.resolution = state.resolution;
  scene.timeline.frames_per_second = frames_per_second;
  add_camera(scene, state.camera);
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
  const Vec3d in_file(origin.x, origin.y, -origin.z);  // mirrored, as handedness.hpp has it
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
