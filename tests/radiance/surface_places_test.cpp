// How far things and lights move from frame to frame.
#include "radiance/surface_places.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

/// How far a point on the instance's first side moves between the moments 0 and 0.5 s.
float moved(const Scene& scene, int instance) {
  const ThreadPool pool(1);
  DeviceScene device(scene, pool, Integrator::kPath);
  SurfacePlaces places(device.shaded());
  for (const double time : {0.0, 0.5}) {
    const ResolvedScene resolved = evaluate(scene, time);
    device.update(resolved, pool);
    places.update(resolved);
  }
  return places.moved(hash(static_cast<std::uint32_t>(instance), 0u), {0.1f, 0.2f, 0.3f});
}

PhongSurface lamp() {
  PhongSurface s = matte(Vec3f(0.0f));
  s.emission = Vec3f(1.0f);
  return s;
}

TEST(SurfacePlaces, things_move_as_far_as_their_nodes) {
  SmallScene s;
  const int white = s.material(matte(Vec3f(0.8f)));
  const int still = s.add(square(1, 0), white);
  const int moving = s.add(square(1, 0), white, s.moving_node({0, 0, 0}, {0, 3, 4}));
  EXPECT_FLOAT_EQ(moved(s.scene, moving), 2.5f);
  EXPECT_EQ(moved(s.scene, still), 0.0f);
}

TEST(SurfacePlaces, lights_move_everything_by_their_share) {
  SmallScene s;
  const int white = s.material(matte(Vec3f(0.8f))), shines = s.material(lamp());
  const int still = s.add(square(1, 0), white);
  s.add(square(0.5f, 0), shines, s.moving_node({0, 0, 2}, {4, 0, 2}));
  EXPECT_NEAR(moved(s.scene, still), 2.0f, 1e-5f);
  s.add(square(0.5f, 3), shines);  // as much light again, and it stays
  EXPECT_NEAR(moved(s.scene, still), 1.0f, 1e-5f);
}

TEST(SurfacePlaces, point_like_lights_count_likewise) {
  SmallScene s;
  const int still = s.add(square(1, 0), s.material(matte(Vec3f(0.8f))));
  s.point_light({0, 0, 3}).node = s.moving_node({0, 0, 3}, {0, 1, 3});
  EXPECT_NEAR(moved(s.scene, still), 0.5f, 1e-5f);
}

// A ray from above meets a triangle whose normals lie about 45 degrees between two sides: it is of one and near the other.
// Where normals are all the same, it may be a face of a box that is turned, and is near none.
TEST(SurfacePlaces, sides_overlap_where_a_surface_is_smooth) {
  const auto sides_near = [](Vec3f at_corner) {
    const Vec3f between = glm::normalize(Vec3f(1.0f, 0.0f, 1.02f));
    SmallScene s;
    Mesh mesh;
    mesh.positions = {{-1, -1, 1}, {1, -1, -1}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals = {between, between, glm::normalize(at_corner)};
    s.add(mesh, s.material(matte(Vec3f(0.8f))));
    const ThreadPool pool(1);
    DeviceScene device(s.scene, pool, Integrator::kPath);
    device.update(evaluate(s.scene, 0.0), pool);
    SurfacePlaces places(device.shaded());
    RayHitPacket packet{};
    SurfacePacket surface{};
    surface.record[0] = 0, surface.instance[0] = 0, packet.hit.primID[0] = 0;
    return std::pair(places.sides_near(packet, surface, 0, between),
                     places.sides_near(packet, surface, 0, Vec3f(0.1f, 0.0f, 1.0f)));
  };
  const std::uint32_t along_x = hash(0u, 0u), none = 0;
  const auto [between, far] = sides_near({1.0f, 0.2f, 1.0f});
  EXPECT_EQ(between[0], along_x);
  EXPECT_EQ(between[1], none);
  EXPECT_EQ(far[0], none);
  const auto [of_flat, far_of_flat] = sides_near({1.0f, 0.0f, 1.02f});
  EXPECT_EQ(of_flat[0], none);
  EXPECT_EQ(far_of_flat[0], none);
}

}  // namespace
}  // namespace lippmann
