// Lights that are too weak or too strong for single precision must give finite pictures.
#include "transport/light_range.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

enum class Source {
  kGradient,
  kPanorama,
  kFaintStrength,
  kSun,
  kPoint,
  kBall,
  kSpot,
  kDistant,
  kWeb,
  kSquare,
  kTexture,
  kGlow
};
constexpr Source kSources[] = {Source::kGradient, Source::kPanorama, Source::kFaintStrength, Source::kSun,
                               Source::kPoint,    Source::kBall,     Source::kSpot,          Source::kDistant,
                               Source::kWeb,      Source::kSquare,   Source::kTexture,       Source::kGlow};

void add_panorama(SmallScene& s, float texel, float strength) {
  EnvironmentMap map{Image(8, 4, 3)};
  map.radiance.pixel(3, 1)[1] = texel;
  map.strength = strength;
  s.scene.background.map = map;
}

void add_lamp(SmallScene& s, Source source, float light) {
  Light& lamp = s.point_light({0.3f, 0.0f, 2.0f}, Vec3f(light));
  lamp.inverse_square = true;
  if (source == Source::kBall) lamp.radius = 0.2f;
  if (source == Source::kDistant) lamp.kind = LightKind::kDirectional;
  if (source == Source::kSpot) lamp.kind = LightKind::kSpot, lamp.inner_cone = 0.3f, lamp.outer_cone = 0.8f;
  if (source != Source::kWeb) return;
  lamp.web = 0;
  PhotometricWeb web;
  web.polar = {0.0f, kPi}, web.azimuth = {0.0f}, web.intensity = {1.0f, 1.0f};
  s.scene.webs.push_back(web);
}

void add_surface(SmallScene& s, Source source, float light) {
  MetallicRoughness shining;
  shining.emissive = Vec3f(light);
  if (source == Source::kTexture) {
    Texture texture;
    texture.width = texture.height = 1, texture.rgba = {1, 1, 1, 255};
    s.scene.textures.push_back(texture);
    shining.emissive_map.texture = 0;
  }
  if (source == Source::kGlow) {
    PhongSurface glow = matte(Vec3f(0.0f));
    glow.emission = Vec3f(light);
    s.add(square(0.5f, 2.0f), s.material(glow));
  } else {
    s.add(square(0.5f, 2.0f), s.material(shining));
  }
}

SmallScene lit_by(Source source, float light) {
  SmallScene s;
  s.scene.max_depth = 3;
  MetallicRoughness floor;
  floor.metallic = 0.0f, floor.roughness = 0.5f;
  s.add(square(2.0f, 0.0f), s.material(floor));
  switch (source) {
    case Source::kGradient:
      surround(s, Vec3f(light));
      break;
    case Source::kPanorama:
      add_panorama(s, light, 1.0f);
      break;
    case Source::kFaintStrength:
      add_panorama(s, 1e-3f, light);
      break;
    case Source::kSun:
      s.scene.background.map = sunny_sky(Vec3f(light), {0.0f, 0.3f, 1.0f}, Vec3f(std::min(1e-3f * light, 1e30f)));
      break;
    case Source::kSquare:
    case Source::kTexture:
    case Source::kGlow:
      add_surface(s, source, light);
      break;
    default:
      add_lamp(s, source, light);
  }
  return s;
}

bool all_finite(const Image& film) {
  return std::all_of(film.data.begin(), film.data.end(), [](float v) { return std::isfinite(v); });
}

TEST(LightRange, faint_light_of_every_source_is_dark) {
  for (const Source source : kSources)
    for (const float light : {std::numeric_limits<float>::denorm_min(), 2e-41f, 1.2e-38f, 1e-30f}) {
      const Scene scene = lit_by(source, light).scene;
      for (const Image& film :
           {trace_paths(scene, single_view(8), 4, {}, 1, kNearby).film, trace(scene, single_view(8), {}, 1, 0.0, kNearby).film})
        EXPECT_TRUE(all_finite(film) && mean(film) < 1e-20) << static_cast<int>(source) << ", " << light;
    }
}

TEST(LightRange, strong_light_of_every_source_is_finite) {
  for (const Source source : kSources)
    for (const float light : {1e20f, std::numeric_limits<float>::max()}) {
      const Scene scene = lit_by(source, light).scene;
      const Image film = trace_paths(scene, single_view(8), 64, {}, 1, kNearby).film;
      EXPECT_TRUE(all_finite(film)) << static_cast<int>(source) << ", " << light;
      EXPECT_GT(mean(film), 1e10) << static_cast<int>(source) << ", " << light;
    }
}

TEST(LightRange, visible_light_is_kept) {
  for (const float light : {0.0f, 1e-20f, 1.0f, 1e29f}) EXPECT_EQ(in_light_range(light), light);
  EXPECT_EQ(in_light_range(2e-41f), 0.0f);
  EXPECT_EQ(in_light_range(-kInfinity), -kStrongestLight);
}

}  // namespace
}  // namespace lippmann
