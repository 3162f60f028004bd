// What a frame of shared light gets where it errs by too much.
#include "radiance/mending.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

constexpr FrameError kAllowed{1.0f, 1.0f, 0.0f, 0.0f};

FrameErrors errors_of(float pixels, float blocks) {
  FrameErrors errors;
  errors.add({pixels, blocks, 0.01f, 0.01f}, kAllowed);
  return errors;
}

Remedy remedy_of(float pixels, float blocks, EdgesToPaths edges = EdgesToPaths::kNone) {
  const FrameErrors errors = errors_of(pixels, blocks);
  return remedy_for(errors, errors.latest(), kAllowed, edges);
}

TEST(Mending, noise_where_the_light_is_right_takes_samples_alone) {
  const Remedy remedy = remedy_of(1.4f, 0.3f);
  EXPECT_TRUE(remedy.finer_pixels);
  EXPECT_FALSE(remedy.more_edges);
  EXPECT_FALSE(remedy.more_updates);
}

TEST(Mending, noise_where_means_are_nearly_too_wrong_takes_updates_too) {
  const Remedy remedy = remedy_of(1.4f, 0.9f);
  EXPECT_TRUE(remedy.finer_pixels);
  EXPECT_FALSE(remedy.more_edges);
  EXPECT_TRUE(remedy.more_updates);
}

TEST(Mending, means_that_are_wrong_take_edges_until_there_are_no_more_and_then_updates) {
  EXPECT_TRUE(remedy_of(0.4f, 2.0f).more_edges);
  EXPECT_FALSE(remedy_of(0.4f, 2.0f).more_updates);
  EXPECT_FALSE(remedy_of(0.4f, 2.0f).finer_pixels);
  EXPECT_TRUE(remedy_of(0.8f, 2.0f).finer_pixels);
  EXPECT_FALSE(remedy_of(0.4f, 2.0f, EdgesToPaths::kFaint).more_edges);
  EXPECT_TRUE(remedy_of(0.4f, 2.0f, EdgesToPaths::kFaint).more_updates);
}

TEST(Mending, helps_where_a_tenth_of_what_is_too_much_is_gone) {
  const FrameErrors of_pixels = errors_of(1.4f, 0.3f), of_blocks = errors_of(0.5f, 2.0f);
  EXPECT_TRUE(has_helped({.finer_pixels = true}, of_pixels, {1.4f, 0.3f}, {1.2f, 0.3f}));
  EXPECT_FALSE(has_helped({.finer_pixels = true}, of_pixels, {1.4f, 0.3f}, {1.3f, 0.1f}));
  EXPECT_TRUE(has_helped({.more_updates = true}, of_blocks, {0.5f, 2.0f}, {0.5f, 1.5f}));
  EXPECT_FALSE(has_helped({.more_updates = true}, of_blocks, {0.5f, 2.0f}, {0.1f, 1.9f}));
  EXPECT_TRUE(has_helped({.more_edges = true}, of_blocks, {0.5f, 2.0f}, {0.5f, 2.0f}));
}

TEST(Mending, six_times_the_error_is_hopeless_and_twice_is_far_off) {
  EXPECT_FALSE(is_hopeless({5.9f, 5.9f}, kAllowed));
  EXPECT_TRUE(is_hopeless({6.1f, 0.0f}, kAllowed));
  EXPECT_TRUE(is_hopeless({0.0f, 6.1f}, kAllowed));
  EXPECT_FALSE(is_far_off({1.9f, 1.9f}, kAllowed));
  EXPECT_TRUE(is_far_off({0.0f, 2.1f}, kAllowed));
}

}  // namespace
}  // namespace lippmann
