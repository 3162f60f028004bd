// A square covers 16 x 16 pixels with 4 texels per pixel, black on the left and white on the right. Grey grows linearly
// from 0 at 1/8 of a pixel left of the edge to 1/2 at the edge.
#include <gtest/gtest.h>

#include "shading/surface.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kPixels = 16, kTexels = 64;

SmallScene edge() {
  SmallScene s;
  s.scene.max_depth = 2;
  Texture t;
  t.width = t.height = kTexels;
  t.srgb = false;
  t.wrap_u = t.wrap_v = Wrap::kClamp;
  for (int i = 0; i < kTexels * kTexels; ++i)
    for (int c = 0; c < 4; ++c) t.rgba.push_back(c == 3 || i % kTexels >= kTexels / 2 ? 255 : 0);
  s.scene.textures.push_back(t);
  MetallicRoughness surface;
  surface.unlit = true;
  surface.base_color_map.texture = 0;
  s.add(square(2.0f, 0.0f), s.material(surface));
  return s;
}

TEST(BeamFootprint, many_samples_average_a_pixel) {
  // Grey rises from 0 to 1/2 over the last eighth of the pixel, so the pixel's mean is 1/32. The 64 samples lie in 64
  // columns with a random shift of less than a column, which changes the mean by at most 1/256.
  TraceParams params;
  params.spp = 64;
  for (const Integrator integrator : {Integrator::kWhitted, Integrator::kPath}) {
    const SmallScene s = edge();
    const Picture p = trace(s.scene, single_view(kPixels), params, 1, 0.0, {}, integrator);
    EXPECT_NEAR(p.at(7, 8).x, 1.0f / 32.0f, 1.0f / 256.0f + 1e-3f);
    EXPECT_NEAR(p.at(8, 8).x, 31.0f / 32.0f, 1.0f / 256.0f + 1e-3f);
    EXPECT_EQ(p.at(6, 8).x, 0.0f);
  }
}

TEST(BeamFootprint, one_sample_covers_a_pixel) {
  // The sample uses the level whose texels are as large as pixels. There, grey grows linearly between the centres of
  // the last black and the first white texel. The map is shifted so that pixel 7 is at 1/4 of this distance.
  SmallScene s = edge();
  std::get<MetallicRoughness>(s.scene.materials[0].surface).base_color_map.offset.x = 1.0f / (4.0f * kPixels);
  const Picture p = trace(s.scene, single_view(kPixels), {});
  EXPECT_NEAR(p.at(7, 8).x, 0.25f, 1e-3f);
}

TEST(BeamFootprint, samples_share_a_pixels_width) {
  const Optics optics = single_view(kPixels);
  const float whole = BeamFootprint(optics, {}).widths(10.0f).x;
  EXPECT_NEAR(whole, 0.25f, 1e-6f);
  EXPECT_EQ(BeamFootprint(optics, {}).sample_widths(10.0f).x, whole);
  EXPECT_EQ(BeamFootprint(optics, {}, 4).sample_widths(10.0f).x, whole / 2.0f);
  EXPECT_EQ(BeamFootprint(optics, {}, 1000).sample_widths(10.0f).x, whole / 8.0f);
  EXPECT_EQ(BeamFootprint(optics, {}, 1000).widths(10.0f).x, whole);
}

TEST(BeamFootprint, scattered_rays_are_as_wide_as_a_pixel) {
  const SmallScene s = edge();
  const ThreadPool pool(1);
  DeviceScene device(s.scene, pool, Integrator::kPath);
  device.update(evaluate(s.scene, 0.0), pool);
  // The rays hit a point a quarter of a pixel left of the edge. The point is black in the finest level, and has the
  // value 1/4 in the level whose texels are as large as pixels.
  RayHitPacket packet;
  LaneMask active, spread;
  for (int i = 0; i < kLanes; ++i) {
    packet.ray.org_x[i] = -0.0625f, packet.ray.org_y[i] = 0.1f, packet.ray.org_z[i] = 10.0f;
    packet.ray.dir_x[i] = packet.ray.dir_y[i] = 0.0f, packet.ray.dir_z[i] = -1.0f;
    packet.ray.tnear[i] = 0.0f, packet.ray.tfar[i] = kInfinity;
    active.lane[i] = -1;
    spread.lane[i] = i % 2 ? -1 : 0;
  }
  device.shaded().trace(active, packet, Coherence::kCoherent);
  const Optics optics = single_view(kPixels);
  SurfacePacket surface;
  evaluate_surfaces(device.shaded(), packet, active, Lanes{}, BeamFootprint(optics, {}, 64), surface, &spread);
  for (int i = 0; i < kLanes; ++i) EXPECT_NEAR(surface.color.x[i], i % 2 ? 0.25f : 0.0f, 1e-3f) << i;
}

}  // namespace
}  // namespace lippmann
