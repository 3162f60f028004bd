#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann::test {

/// Returns a closed cube of six white walls, 2 * size wide. Each wall is an instance.
inline Scene room_of_six_walls(float size = 1.0f, Vec3f center = Vec3f(0.0f)) {
  Mesh square;
  square.positions = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  Scene scene;
  scene.shapes.emplace_back(std::move(square));
  scene.materials.push_back({"white", MetallicRoughness{}});
  const Vec3f up(0, 1, 0), right(1, 0, 0);
  for (const auto& [axis, degrees] : {std::pair(up, 0.0f), std::pair(up, 90.0f), std::pair(up, 180.0f), std::pair(up, 270.0f),
                                      std::pair(right, 90.0f), std::pair(right, -90.0f)}) {
    Node node;
    node.local = {center, glm::angleAxis(radians(degrees), axis), Vec3f(size)};
    Instance wall;
    wall.shape = 0, wall.material = 0, wall.node = static_cast<int>(scene.nodes.size());
    scene.nodes.push_back(node);
    scene.instances.push_back(wall);
  }
  return scene;
}

}  // namespace lippmann::test
