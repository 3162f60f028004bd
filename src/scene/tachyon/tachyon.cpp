#include "scene/tachyon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/tachyon/camera_path.hpp"
#include "scene/tachyon/parser.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Puts the camera on a node of its own.
void add_camera(Scene& scene, const tachyon::CameraRecord& record) {
  Node node;
  node.name = "camera";
  node.local = tachyon::node_of(record.pose);
  Camera camera = tachyon::camera_of(record, scene.resolution);
  camera.node = static_cast<int>(scene.nodes.size());
  scene.nodes.push_back(std::move(node));
  scene.cameras.push_back(std::move(camera));
}

void animate_camera(Scene& scene, const fs::path& path) {
  tachyon::SceneFolder folder(path);
  tachyon::Lexer lexer(path.string(), folder.read_text(path, path.string()));
  const std::vector<tachyon::CameraPose> poses = tachyon::parse_camera_path(lexer);
  const int node = scene.cameras.front().node;
  scene.nodes[static_cast<std::size_t>(node)].local = tachyon::node_of(poses.front());
  tachyon::animate(scene.timeline, node, poses);
}

}  // namespace

Scene load_tachyon(const fs::path& path, const std::optional<fs::path>& camera_path, const Context& context,
                   double frames_per_second) {
  tachyon::SceneFolder folder(path);
  tachyon::Lexer lexer(path.string(), folder.read_text(path, path.string()));
  tachyon::ParserState state(folder, context);
  tachyon::parse_scene(lexer, state);
  if (const int count = state.builder.left_out(); count > 0)
    context.warning(fmt::format("{}: {} shapes without extent are left out.", path.string(), count));

  Scene scene = state.builder.take();
  scene.name = path.stem().string();
  scene.background = state.background;
  scene.encoding = Encoding::kTachyonTruncate;
  scene.max_depth = std::max(state.camera.ray_depth, 1);
  scene.resolution = state.resolution;
  scene.timeline.frames_per_second = frames_per_second;
  add_camera(scene, state.camera);
  if (camera_path) animate_camera(scene, *camera_path);
  return scene;
}

}  // namespace lippmann
