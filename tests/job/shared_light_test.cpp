#include "job/shared_light.hpp"

#include <gmock/gmock.h>

namespace lippmann {
namespace {

using testing::HasSubstr;

FrameReport traced_frame(int number) {
  FrameReport frame;
  frame.frame = number;
  return frame;
}

FrameReport shared_frame(int number, double psnr_db, double at_least_db, double block_psnr_db) {
  FrameReport frame = traced_frame(number);
  frame.kind = "shared";
  frame.estimated_psnr_db = psnr_db, frame.psnr_at_least_db = at_least_db, frame.estimated_block_psnr_db = block_psnr_db;
  return frame;
}

TEST(SharedLight, sentence_counts_frames_and_names_the_worst_of_pixels_and_of_means) {
  const std::vector<FrameReport> frames{shared_frame(4, 40.0, 39.0, 50.0), traced_frame(5), shared_frame(6, 30.0, 29.0, 52.0),
                                        traced_frame(7)};
  // Squared errors of 1e-4 and 1e-3: their mean is 5.5e-4, which is 32.6 dB.
  EXPECT_EQ(shared_light_sentence(frames),
            "2 of 4 frames share light, the others were traced in full; estimated PSNR 32.6 dB on average, 30.0 dB at worst "
            "(frame 6); averaged over blocks of 64 pixels, 50.0 dB at worst (frame 4)");
}

TEST(SharedLight, sentence_counts_frames_that_share_light) {
  EXPECT_THAT(shared_light_sentence({shared_frame(0, 40.0, 39.0, 50.0), shared_frame(1, 41.0, 40.0, 51.0)}),
              testing::StartsWith("2 of 2 frames share light; estimated PSNR"));
  EXPECT_EQ(shared_light_sentence({traced_frame(0), traced_frame(1)}), "every frame was traced in full");
  EXPECT_EQ(shared_light_sentence({traced_frame(0)}), "the frame was traced in full");
}

TEST(SharedLight, sentence_tells_the_errors_of_traced_frames_that_were_measured) {
  FrameReport measured = shared_frame(1, 30.0, 29.0, 48.0);
  measured.kind = "full";
  EXPECT_EQ(
      shared_light_sentence({traced_frame(0), measured}),
      "every frame was traced in full; estimated PSNR 30.0 dB on average, 30.0 dB at worst (frame 1); averaged over blocks of "
      "64 pixels, 48.0 dB at worst (frame 1)");
  EXPECT_THAT(below_floor_sentence({traced_frame(0), measured}, 30.0), testing::StartsWith("frame 1 may be below"));
}

TEST(SharedLight, sentence_of_a_single_frame_has_no_average) {
  EXPECT_EQ(shared_light_sentence({shared_frame(3, 38.84, 37.0, 52.06)}),
            "the frame shares light; estimated PSNR 38.8 dB (52.1 dB averaged over blocks of 64 pixels)");
}

TEST(SharedLight, frames_are_below_a_floor_that_their_lower_bound_does_not_reach) {
  const std::vector<FrameReport> frames{shared_frame(0, 41.0, 40.0, 50.0), shared_frame(1, 41.0, 39.9, 50.0), traced_frame(2),
                                        shared_frame(3, 39.5, 38.0, 50.0)};
  EXPECT_EQ(below_floor_sentence(frames, 40.0),
            "frames 1, 3 may be below --min-psnr 40 (at 95 % confidence); 1 estimate is below it");
  EXPECT_EQ(below_floor_sentence(frames, 39.0),
            "frame 3 may be below --min-psnr 39 (at 95 % confidence); no estimate is below it");
  EXPECT_EQ(below_floor_sentence(frames, 38.0), "");
}

TEST(SharedLight, frames_that_are_not_measured_are_not_known_to_reach_a_floor) {
  const std::vector<FrameReport> frames{traced_frame(0), shared_frame(1, 41.0, 39.9, 50.0), traced_frame(2)};
  EXPECT_EQ(unmeasured_sentence(frames, 40.0), "the error of frames 0, 2 was not estimated, so --min-psnr 40 is not confirmed");
  EXPECT_THAT(unmeasured_sentence({frames[2]}, 40.0), HasSubstr("frame 2 was not estimated"));
  EXPECT_EQ(unmeasured_sentence({frames[1]}, 40.0), "");
}

FrameReport seen_frame(int number, double psnr_db, double at_eye_db) {
  FrameReport frame = shared_frame(number, psnr_db, psnr_db - 1.0, 50.0);
  frame.estimated_psnr_at_eye_db = at_eye_db, frame.psnr_at_eye_at_least_db = at_eye_db - 0.5;
  return frame;
}

TEST(SharedLight, sentence_tells_the_error_at_the_eye_where_that_is_another) {
  EXPECT_EQ(shared_light_sentence({seen_frame(3, 38.8, 40.1)}),
            "the frame shares light; estimated PSNR 38.8 dB, 40.1 dB at the eye (50.0 dB averaged over blocks of 64 pixels)");
  EXPECT_THAT(shared_light_sentence({seen_frame(3, 38.8, 40.1), seen_frame(4, 38.9, 39.9)}),
              HasSubstr("38.8 dB at worst (frame 3), 39.9 dB at worst at the eye; averaged over blocks of 64 pixels, 50.0 dB"));
  EXPECT_THAT(shared_light_sentence({seen_frame(3, 38.8, 38.8)}), testing::Not(HasSubstr("eye")));
}

TEST(SharedLight, a_floor_at_the_eye_is_held_there) {
  const std::vector<FrameReport> frames{seen_frame(0, 36.0, 40.0), seen_frame(1, 45.0, 39.2)};
  EXPECT_EQ(below_floor_sentence(frames, 39.5, QualityAt::kEye),
            "frame 1 may be below --min-psnr 39.5 at the eye (at 95 % confidence); 1 estimate is below it");
  EXPECT_EQ(below_floor_sentence(frames, 38.7, QualityAt::kEye), "");
  EXPECT_THAT(below_floor_sentence(frames, 38.7), testing::StartsWith("frame 0 may be below --min-psnr 38.7 (at 95 %"));
}

TEST(SharedLight, many_frames_below_a_floor_are_counted) {
  std::vector<FrameReport> frames;
  for (int f = 10; f < 17; ++f) frames.push_back(shared_frame(f, 35.0, 34.0, 50.0));
  EXPECT_EQ(below_floor_sentence(frames, 36.5),
            "frames 10, 11, 12, 13, 14 and 2 more may be below --min-psnr 36.5 (at 95 % confidence); 7 estimates are "
            "below it");
}

}  // namespace
}  // namespace lippmann
