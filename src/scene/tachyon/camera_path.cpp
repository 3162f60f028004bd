#include "scene/tachyon/camera_path.hpp"

#include <limits>

namespace lippmann::tachyon {

std::vector<CameraPose> parse_camera_path(Lexer& lexer) {
  std::vector<CameraPose> poses;
  do {
    CameraPose pose;
    pose.view = lexer.vector("a view direction");
    pose.up = lexer.vector("an up direction");
    pose.center = lexer.point("a camera's centre");
    require_orientation(pose, lexer);
    poses.push_back(pose);
  } while (!lexer.at_end());
  return poses;
}

void animate(Timeline& timeline, int node, const std::vector<CameraPose>& poses) {
  NodeAnimation animation;
  animation.node = node;
  animation.translation.interpolation = animation.rotation.interpolation = Interpolation::kStep;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Transform transform = node_of(poses[i]);
    animation.translation.times.push_back(timeline.time(static_cast<int>(i)));
    animation.translation.values.push_back(transform.translation);
    animation.rotation.values.push_back(transform.rotation);
  }
  animation.rotation.times = animation.translation.times;
  timeline.animations.push_back(std::move(animation));
  timeline.frame_count = static_cast<int>(poses.size()) + 1;
}

}  // namespace lippmann::tachyon
