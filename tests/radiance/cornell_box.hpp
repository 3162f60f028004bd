// A box of matt walls, for tests of shared light.
#pragma once

#include "trace/small_scene.hpp"

namespace lippmann::test {

/// Open towards the viewer, with a light below its lid; half side 2.
inline SmallScene cornell_box() {
  SmallScene s;
  s.scene.max_depth = 6;
  const int white = s.material(matte(Vec3f(0.7f))), red = s.material(matte({0.6f, 0.1f, 0.1f})),
            green = s.material(matte({0.1f, 0.5f, 0.1f}));
  const auto wall = [&](Vec3f a, Vec3f b, Vec3f c, Vec3f d, int material) {
    Mesh m;
    m.positions = {a, b, c, d};
    m.triangles = {{0, 1, 2}, {0, 2, 3}};
    s.add(m, material);
  };
  wall({-2, -2, -2}, {2, -2, -2}, {2, 2, -2}, {-2, 2, -2}, white);
  wall({-2, -2, 2}, {2, -2, 2}, {2, -2, -2}, {-2, -2, -2}, white);
  wall({-2, 2, -2}, {2, 2, -2}, {2, 2, 2}, {-2, 2, 2}, white);
  wall({-2, -2, 2}, {-2, -2, -2}, {-2, 2, -2}, {-2, 2, 2}, red);
  wall({2, -2, -2}, {2, -2, 2}, {2, 2, 2}, {2, 2, -2}, green);
  s.point_light({0.0f, 1.5f, 0.0f}, Vec3f(0.5f));
  s.add(Boxes{{{-1.0f, -2.0f, -1.0f}, {0.0f, -0.5f, 0.0f}}}, white);
  return s;
}

/// The same without the light: all walls and the box shine with 1 and send on 0.9 of what they receive.
inline SmallScene shining_box(int max_depth) {
  SmallScene s = cornell_box();
  PhongSurface wall = matte(Vec3f(0.9f));
  wall.emission = Vec3f(1.0f);
  for (Material& material : s.scene.materials) material.surface = wall;
  s.scene.lights.clear();
  s.scene.max_depth = max_depth;
  return s;
}

}  // namespace lippmann::test
