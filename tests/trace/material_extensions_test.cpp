// Volumes, prisms and leaves, compared with theory. The camera at (0, 0, 10) sees the square from -2 to 2 in x and y at z = 0.
#include <gtest/gtest.h>

#include <cmath>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

MetallicRoughness clear(const Volume& volume, float ior = 1.0f) {
  MetallicRoughness m;
  m.metallic = 0.0f, m.roughness = 0.0f, m.ior = ior;
  m.specular = 0.0f, m.transmission = 1.0f;
  m.extensions.emplace().volume = volume;
  return m;
}

constexpr Volume kAmber{true, {0.9f, 0.5f, 0.1f}, 2.0f};

TEST(MaterialExtensions, slabs_absorb_by_beers_law) {
  SmallScene s;
  s.scene.max_depth = 8;
  surround(s, Vec3f(1.0f));
  s.add(Boxes{{{-50, -50, -3}, {50, 50, 0}}}, s.material(clear(kAmber)));
  const Vec3f seen = trace_paths(s.scene, single_view(33), 64).at(16, 16);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], std::pow(kAmber.attenuation_color[c], 3.0f / 2.0f), 1e-3f);
}

TEST(MaterialExtensions, enclosed_objects_are_seen_through_the_medium) {
  SmallScene s;
  s.scene.max_depth = 8;
  s.add(Boxes{{{-50, -50, -3}, {50, 50, 0}}}, s.material(clear(kAmber)));
  s.add(square(20, -1), s.material(glowing(Vec3f(1.0f))));
  const Vec3f seen = trace_paths(s.scene, single_view(33), 64).at(16, 16);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], std::pow(kAmber.attenuation_color[c], 1.0f / 2.0f), 1e-3f);
}

TEST(MaterialExtensions, open_volumes_absorb_nothing) {
  SmallScene s;
  s.scene.max_depth = 8;
  surround(s, Vec3f(1.0f));
  s.add(square(50, 0), s.material(clear(kAmber)));
  EXPECT_NEAR(mean(trace_paths(s.scene, single_view(8), 16).film), 1.0, 1e-4);
}

TEST(MaterialExtensions, thin_walls_do_not_refract) {
  for (const bool by_paths : {false, true}) {
    SmallScene s;
    s.scene.max_depth = 8;
    s.add(Spheres{{{0, 0, 0}, 1.5f}}, s.material(clear({}, 1.5f)));
    s.add(square(50, -3), s.material(glowing(Vec3f(1.0f))));
    // A lens would spread this dark square over the whole sphere.
    s.add(square(0.5f, -2.9f), s.material(glowing(Vec3f(0.0f))));
    const Picture p = by_paths ? trace_paths(s.scene, single_view(33), 256) : trace(s.scene, single_view(33));
    EXPECT_NEAR(p.at(16, 16).x, 0.0f, 0.15f) << by_paths;
    EXPECT_GT(p.at(24, 16).x, 0.7f) << by_paths;
  }
}

TEST(MaterialExtensions, layered_white_spheres_vanish_in_furnaces) {
  for (int kind = 0; kind < 4; ++kind) {
    MetallicRoughness m;
    m.metallic = 0.0f, m.roughness = 0.5f;
    SurfaceExtensions& e = m.extensions.emplace();
    if (kind == 0) e.diffuse_transmission.share = 0.5f;
    if (kind == 1) m.transmission = 1.0f, e.volume = Volume{};
    if (kind == 2) m.transmission = 1.0f, e.volume = Volume{true}, m.roughness = 0.0f;
    if (kind == 3) m.transmission = 1.0f, e.dispersion = 1.0f, m.roughness = 0.0f;
    SmallScene s;
    s.scene.max_depth = 64;
    surround(s, Vec3f(1.0f));
    s.add(Spheres{{{0, 0, 0}, 3.0f}}, s.material(m));
    // With dispersion, each path has only one colour, which adds noise.
    EXPECT_NEAR(mean(trace_paths(s.scene, single_view(8), 1024).film), 1.0, 0.01) << "kind " << kind;
  }
}

// The edge of a dark square is seen through a prism, which bends red light less than blue light.
TEST(MaterialExtensions, dispersion_separates_colours) {
  SmallScene s;
  s.scene.max_depth = 8;
  MetallicRoughness m = clear({true}, 1.5f);
  m.extensions->dispersion = 4.0f;
  s.add(Spheres{{{0, 0, 0}, 1.5f}}, s.material(m));
  s.add(square(50, -4), s.material(glowing(Vec3f(1.0f))));
  s.add(square(0.7f, -3.9f), s.material(glowing(Vec3f(0.0f))));
  const Picture p = trace_paths(s.scene, single_view(33), 256);
  float parted = 0.0f;
  for (int x = 0; x < 33; ++x) parted = std::max(parted, std::abs(p.at(x, 16).x - p.at(x, 16).z));
  EXPECT_GT(parted, 0.3f);
}

TEST(MaterialExtensions, leaves_transmit_diffuse_light) {
  MetallicRoughness leaf;
  leaf.metallic = 0.0f, leaf.roughness = 1.0f, leaf.specular = 0.0f;
  leaf.extensions.emplace().diffuse_transmission = {0.5f, {}, {0.2f, 0.8f, 0.1f}, {}};
  SmallScene s;
  s.add(square(20, 0), s.material(leaf));
  Light& light = s.point_light({0, 0, 0}, Vec3f(kPi));
  light.kind = LightKind::kDirectional;
  s.scene.nodes[static_cast<std::size_t>(light.node)].matrix =
      Affine3f{Mat3f(-1, 0, 0, 0, 1, 0, 0, 0, -1), Vec3f(0.0f)};  // shines upwards, at the back of the leaf
  const Vec3f seen = trace_paths(s.scene, single_view(9), 64).at(4, 4);
  EXPECT_NEAR(seen.x, 0.5f * 0.2f, 2e-3f);
  EXPECT_NEAR(seen.y, 0.5f * 0.8f, 2e-3f);
}

}  // namespace
}  // namespace lippmann
