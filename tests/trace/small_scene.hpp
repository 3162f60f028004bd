#pragma once

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "trace/first_hits.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann::test {

class SmallScene {
 public:
  SmallScene() {
    scene.background.horizon = scene.background.zenith = Vec3f(0.0f);
    scene.max_depth = 1;
  }

  int node(const Affine3f& world_from_node) {
    scene.nodes.push_back({"", -1, {}, world_from_node});
    return static_cast<int>(scene.nodes.size()) - 1;
  }

  int moving_node(Vec3f position, Vec3f position_after_a_second) {
    scene.nodes.push_back({"", -1, {}, {}});
    NodeAnimation animation;
    animation.node = static_cast<int>(scene.nodes.size()) - 1;
    animation.translation.times = {0.0, 1.0};
    animation.translation.values = {position, position_after_a_second};
    scene.timeline.animations.push_back(animation);
    return animation.node;
  }

  template <class Surface>
  int material(const Surface& surface) {
    scene.materials.push_back({"", surface});
    return static_cast<int>(scene.materials.size()) - 1;
  }

  int add(Shape shape, int material_index, int node_index = -1) {
    scene.shapes.push_back(std::move(shape));
    scene.instances.push_back({"", static_cast<int>(scene.shapes.size()) - 1, material_index, node_index});
    return static_cast<int>(scene.instances.size()) - 1;
  }

  Light& point_light(Vec3f position, Vec3f color = Vec3f(1.0f)) {
    Light light;
    light.node = node({Mat3f(1.0f), position});
    light.color = color;
    scene.lights.push_back(light);
    return scene.lights.back();
  }

  Scene scene;
};

/// Default tolerance: rounding of single-precision shading along one path.
inline void expect_color(Vec3f got, Vec3f expected, float tolerance = 2e-5f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], tolerance) << "channel " << c;
}

inline void surround(SmallScene& s, Vec3f light) { s.scene.background.horizon = s.scene.background.zenith = light; }

/// Shows its colour regardless of the light.
inline PhongSurface glowing(Vec3f color) {
  PhongSurface s;
  s.color = color;
  s.ambient = 1.0f;
  s.diffuse = 0.0f;
  return s;
}

inline PhongSurface matte(Vec3f color) {
  PhongSurface s;
  s.color = color;
  s.ambient = 0.0f;
  s.diffuse = 1.0f;
  return s;
}

inline PhongSurface mirror(float share) {
  PhongSurface s = matte(Vec3f(0.0f));
  s.mirror = share;
  return s;
}

/// A uniform sky of `light`, and a sun of one texel, 1.4 degrees wide, close to the direction `toward` with z > 0. The sun adds
/// `irradiance` to surfaces that face it.
inline EnvironmentMap sunny_sky(Vec3f light, Vec3f toward, Vec3f irradiance) {
  constexpr int kWidth = 256, kHeight = 128;
  constexpr double kStep = M_PI / kHeight;
  EnvironmentMap map{Image(kWidth, kHeight, 3)};
  for (std::size_t i = 0; i < map.radiance.data.size(); ++i) map.radiance.data[i] = light[static_cast<int>(i % 3)];
  const Vec3f d = glm::normalize(toward);
  const auto x = static_cast<int>((0.5 + std::atan2(static_cast<double>(d.z), static_cast<double>(d.x)) * 0.5 / M_PI) * kWidth);
  const auto y = static_cast<int>(std::acos(static_cast<double>(d.y)) / kStep);
  // Bilinear interpolation spreads the texel over 2 x 2 texels with a mean weight of 1/4.
  const auto inverse = static_cast<float>(1.0 / (kStep * kStep * std::sin((y + 0.5) * kStep)));
  for (int c = 0; c < 3; ++c) map.radiance.pixel(x, y)[c] += irradiance[c] * inverse;
  return map;
}

/// Two triangles from -half to half in x and y, in the plane z, facing +z. uv is (0, 0) at the top left.
inline Mesh square(float half, float z) {
  Mesh m;
  m.positions = {{-half, half, z}, {half, half, z}, {half, -half, z}, {-half, -half, z}};
  m.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  m.triangles = {{0, 3, 2}, {0, 2, 1}};
  return m;
}

inline int add_lamp_facing_down(SmallScene& s, float half, float z, Vec3f light) {
  MetallicRoughness shining;
  shining.emissive = light;
  const Affine3f turned{Mat3f({-1, 0, 0}, {0, 1, 0}, {0, 0, -1}), {0, 0, z}};
  return s.add(square(half, 0), s.material(shining), s.node(turned));
}

/// Spheres at random positions on a long box below one light. The spheres are matte (material 0), mirrors (1) or glass
/// (2).
inline SmallScene busy_scene(unsigned seed) {
  SmallScene s;
  s.scene.max_depth = 4;
  PhongSurface shiny = matte(Vec3f(0.5f));
  shiny.mirror = 0.3f;
  PhongSurface glass = matte(Vec3f(0.1f));
  glass.opacity = 0.3f;
  glass.ior = 1.4f;
  const int materials[] = {s.material(matte({0.3f, 0.6f, 0.9f})), s.material(shiny), s.material(glass)};
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1.5f, 1.5f);
  for (int i = 0; i < 12; ++i) s.add(Spheres{{{uniform(random), uniform(random), uniform(random)}, 0.35f}}, materials[i % 3]);
  s.add(Boxes{{{-1.8f, -1.8f, -1.5f}, {1.8f, -1.6f, 1.5f}}}, materials[0]);
  s.point_light({3, 4, 8});
  return s;
}

/// 8 lenses with 8 pixels each, and 50 rows. Shows the same square as single_view().
inline Optics lenticular_view() {
  Optics optics;
  optics.panel = {64, 50, 4.0f / 64};
  LenticularSheet sheet;
  sheet.lens_pitch_mm = 0.5f;
  sheet.gap_mm = 1.0f;
  sheet.offset_mm = 0.25f;
  optics.model = sheet;
  optics.z_front_mm = 10.0f;
  return optics;
}

/// The camera at (0, 0, 10) sees the square from -2 to 2 in x and y at z = 0.
inline Optics single_view(int size) {
  Optics optics;
  optics.panel = {size, size, 4.0f / static_cast<float>(size)};
  optics.model = SingleView{10.0f, {0.0f, 0.0f}};
  return optics;
}

struct Picture {
  Image film;
  FrameAovs aovs;
  RayCounts counts;
  Vec3f at(int x, int y) const {
    const float* p = film.pixel(x, y);
    return {p[0], p[1], p[2]};
  }
};

inline Picture trace(const Scene& scene, const Optics& optics, TraceParams params = {}, int threads = 1, double time = 0.0,
                     const Affine3f& world_from_display = {}, Integrator integrator = Integrator::kWhitted) {
  const ThreadPool pool(threads);
  const Context context;
  DeviceScene device(scene, pool, integrator);
  device.update(evaluate(scene, time), pool);
  params.max_depth = scene.max_depth;
  Picture picture;
  for (const Aov aov : {Aov::kDepth, Aov::kNormal, Aov::kId, Aov::kPosition, Aov::kRayDepth, Aov::kAlbedo})
    picture.aovs.want(aov);
  if (integrator == Integrator::kPath) picture.aovs.want(Aov::kDirect), picture.aovs.want(Aov::kIndirect);
  picture.counts = trace_frame({device, optics, world_from_display}, params, {pool, context}, {picture.film, &picture.aovs});
  find_first_hits({device, optics, world_from_display}, params.order, nullptr, pool, picture.aovs);
  return picture;
}

/// Scales the display by 1/10: the eye at (0, 0, 1) sees the square from -0.2 to 0.2 in x and y.
inline const Affine3f kNearby{Mat3f(0.1f), Vec3f(0.0f)};

inline Picture trace_paths(const Scene& scene, const Optics& optics, int spp, TraceParams params = {}, int threads = 1,
                           const Affine3f& world_from_display = {}) {
  params.spp = spp;
  return trace(scene, optics, params, threads, 0.0, world_from_display, Integrator::kPath);
}

inline double mean(const Image& film) {
  return std::accumulate(film.data.begin(), film.data.end(), 0.0) / static_cast<double>(film.data.size());
}

}  // namespace lippmann::test
