#include "live/live_stage.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "live/live_passes.hpp"
#include "live/live_support.hpp"

namespace lippmann {
namespace {

RenderParams room_of_paths() {
  RenderParams params = test::small_room();
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = 24;
  params.threads = 1;  // with one thread, a frame's progress never decreases
  return params;
}

/// Counts the frames that begin. A frame begins when the reported progress does not increase.
class BegunFrames {
 public:
  explicit BegunFrames(Context& context) {
    context.frame_progress = [this](double share) {
      if (share <= last_) ++begun_;
      last_ = share;
    };
  }

  int count() { return std::exchange(begun_, 0); }

 private:
  int begun_ = 0;
  double last_ = 2.0;
};

struct Looked {
  Context context;
  BegunFrames begun{context};
  LiveStage live{ResolvedJob(room_of_paths()), context};
};

TEST(LiveStage, frames_of_paths_need_no_others) {
  Looked looked, other;
  ASSERT_TRUE(looked.live.frame(4));
  EXPECT_EQ(looked.begun.count(), 1);
  const auto followed = looked.live.frame(6), alone = other.live.frame(6);
  EXPECT_EQ(looked.begun.count(), 1);
  EXPECT_EQ(other.begun.count(), 1);
  ASSERT_TRUE(followed && alone);
  EXPECT_EQ(followed->pictures.film.data, alone->pictures.film.data);
}

TEST(LiveStage, frames_do_not_depend_on_earlier_requests) {
  Looked looked, other;
  const auto wanted = other.live.frame(2);
  ASSERT_TRUE(looked.live.frame(5));
  looked.context.cancelled = true;
  EXPECT_FALSE(looked.live.frame(6));
  looked.context.cancelled = false;
  const auto made = looked.live.frame(2);
  ASSERT_TRUE(wanted && made);
  EXPECT_EQ(made->pictures.film.data, wanted->pictures.film.data);
}

TEST(LiveStage, parameters_change_the_frames) {
  Looked looked;
  const auto before = looked.live.frame(0);
  RenderParams params = room_of_paths();
  looked.live.set(ResolvedJob(params));
  params.scene.view.orbit = {30.0f, 0.0f};
  looked.live.set(ResolvedJob(params));
  const auto turned = looked.live.frame(1);
  const auto back = looked.live.frame(0);
  ASSERT_TRUE(before && turned && back);
  EXPECT_NE(back->pictures.film.data, before->pictures.film.data);
}

TEST(LiveDraft, of_a_late_frame_needs_no_earlier_ones) {
  Looked looked;
  ASSERT_TRUE(draft_pictures(looked.live, looked.live.facts(), 12, looked.context));
  EXPECT_EQ(looked.begun.count(), 1);
}

}  // namespace
}  // namespace lippmann
