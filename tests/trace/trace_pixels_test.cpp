#include "trace/trace_pixels.hpp"

#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

SmallScene scene_of_everything() {
  SmallScene s = busy_scene(7);
  s.scene.background.horizon = {0.2f, 0.3f, 0.5f};
  s.point_light({-1.0f, 1.2f, 1.8f}).visible_radius = 0.3f;
  return s;
}

struct TracedPixels {
  Image film;
  FrameAovs aovs;
  PrimaryPoints points;
};

class TracePixels : public testing::Test {
 protected:
  TracePixels() : s_(scene_of_everything()), pool_(2), device_(s_.scene, pool_) {
    device_.update(evaluate(s_.scene, 0.0), pool_);
    params_.max_depth = s_.scene.max_depth;
  }

  TracedPixels whole() {
    TracedPixels t;
    t.aovs.want(Aov::kDepth), t.aovs.want(Aov::kId);
    trace_frame({device_, optics_, {}}, params_, {pool_, context_}, {t.film, nullptr, &t.points});
    find_first_hits({device_, optics_, {}}, params_.order, nullptr, pool_, t.aovs);
    return t;
  }

  std::vector<std::uint32_t> some_pixels() const {
    std::vector<std::uint32_t> pixels;
    std::mt19937 random(11);
    for (std::uint32_t p = 0; p < 64 * 50; ++p)
      if (random() % 5 == 0) pixels.push_back(p);
    return pixels;
  }

  SmallScene s_;
  Optics optics_ = lenticular_view();
  ThreadPool pool_;
  Context context_;
  DeviceScene device_;
  TraceParams params_;
};

TEST_F(TracePixels, only_given_pixels_change) {
  for (const int spp : {1, 3})
    for (const RayOrder order : {RayOrder::kRows, RayOrder::kColumns, RayOrder::kViewTiles}) {
      params_.spp = spp, params_.order = order;
      const TracedPixels truth = whole();
      Image film(64, 50, 3);
      std::fill(film.data.begin(), film.data.end(), -5.0f);
      PrimaryPoints points;
      points.z.assign(64 * 50, -7.0f), points.object.assign(64 * 50, 77u);
      const std::vector<std::uint32_t> pixels = some_pixels();
      const RayCounts counts = trace_pixels({device_, optics_, {}}, params_, pixels, {pool_, context_}, film, &points);
      EXPECT_EQ(counts.primary, pixels.size() * static_cast<std::size_t>(spp));
      for (std::uint32_t p = 0; p < 64 * 50; ++p) {
        const bool given = std::binary_search(pixels.begin(), pixels.end(), p);
        for (std::size_t c = 0; c < 3; ++c)
          ASSERT_EQ(film.data[3 * p + c], given ? truth.film.data[3 * p + c] : -5.0f) << "spp " << spp << ", pixel " << p;
        ASSERT_EQ(points.z[p], given ? truth.points.z[p] : -7.0f) << "spp " << spp << ", pixel " << p;
        ASSERT_EQ(points.object[p], given ? truth.points.object[p] : 77u) << "spp " << spp << ", pixel " << p;
      }
    }
}

TEST_F(TracePixels, paths_of_given_pixels_are_the_frames) {
  DeviceScene device(s_.scene, pool_, Integrator::kPath);
  device.update(evaluate(s_.scene, 0.0), pool_);
  params_.spp = 4, params_.frame = 3;
  Image truth, film(64, 50, 3);
  trace_frame({device, optics_, {}}, params_, {pool_, context_}, {truth});
  std::fill(film.data.begin(), film.data.end(), -5.0f);
  const std::vector<std::uint32_t> pixels = some_pixels();
  const RayCounts counts = trace_pixels({device, optics_, {}}, params_, pixels, {pool_, context_}, film);
  EXPECT_EQ(counts.primary, pixels.size() * 4);
  for (std::uint32_t p = 0; p < 64 * 50; ++p) {
    const bool given = std::binary_search(pixels.begin(), pixels.end(), p);
    for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(film.data[3 * p + c], given ? truth.data[3 * p + c] : -5.0f) << "pixel " << p;
  }
}

TEST_F(TracePixels, no_pixels_trace_nothing) {
  Image film(64, 50, 3);
  EXPECT_EQ(trace_pixels({device_, optics_, {}}, params_, {}, {pool_, context_}, film).total(), 0u);
}

TEST_F(TracePixels, points_equal_depth_and_object_layers) {
  for (const int spp : {1, 3}) {
    params_.spp = spp;
    const TracedPixels t = whole();
    std::size_t lights = 0, background = 0;
    for (std::size_t p = 0; p < 64 * 50; ++p) {
      // In `points`, light l is object instances.size() + l. In the layer of ids, lights have id -1.
      const std::uint32_t object = t.points.object[p];
      const bool is_light = object == s_.scene.instances.size() + 1;
      lights += is_light, background += object == kNoObject;
      const float id = object < s_.scene.instances.size() ? static_cast<float>(object) : -1.0f;
      ASSERT_EQ(t.aovs[Aov::kId].data[p], id) << p;
      if (is_light)
        ASSERT_NEAR(t.points.z[p], 1.8f, 0.301f);
      else if (object == kNoObject)
        ASSERT_EQ(t.points.z[p], -kInfinity);
      else
        ASSERT_NEAR(t.points.z[p], t.aovs[Aov::kDepth].data[p], 1e-5f) << p;  // rounding of lengths around 10
    }
    EXPECT_GT(lights, 0u);
    EXPECT_GT(background, 0u);
  }
}

TEST_F(TracePixels, keeping_points_changes_no_colour) {
  const TracedPixels with = whole();
  Image without;
  trace_frame({device_, optics_, {}}, params_, {pool_, context_}, {without});
  EXPECT_EQ(with.film.data, without.data);
}

}  // namespace
}  // namespace lippmann
