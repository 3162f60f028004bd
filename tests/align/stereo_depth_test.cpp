#include "align/stereo_depth.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "align/align_module_file.hpp"
#include "align/row_of_cameras.hpp"
#include "support/error_message.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

class StereoDepth : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_align_module_installed()) GTEST_SKIP() << "the module for OpenCV is not built: libopencv-calib3d-dev is missing";
    context_.warn = [this](std::string_view text) { warnings_ += text; };
  }

  Context context_;
  std::string warnings_;
};

/// Returns the fraction of pixels within `radius` of `centre` whose disparity is within half a pixel of `wanted`.
double share_right(const Image& disparity, Vec2d centre, double radius, double wanted) {
  int right = 0, all = 0;
  for (int y = 0; y < disparity.height; ++y)
    for (int x = 0; x < disparity.width; ++x)
      if (glm::length(Vec2d(x, y) - centre) < radius) ++all, right += std::abs(disparity.pixel(x, y)[0] - wanted) < 0.5 ? 1 : 0;
  return static_cast<double>(right) / all;
}

TEST_F(StereoDepth, finds_disparities_in_both_pictures) {
  const StereoDisparity found = disparity_of_pair(shot(0, {}), shot(1, {}), "pair", context_);
  for (const Vec2d centre : {Vec2d(120, 110), Vec2d(520, 370), Vec2d(140, 380)}) {
    EXPECT_GT(share_right(found.of_left, centre, 60.0, -kNearMove), 0.97);
    EXPECT_GT(share_right(found.of_right, centre + Vec2d(kNearMove, 0.0), 60.0, -kNearMove), 0.97);
  }
  EXPECT_GT(share_right(found.of_left, kSceneFocus, 80.0, -kFocusMove), 0.97);
  EXPECT_GT(share_right(found.of_left, {500, 100}, 80.0, -kFarMove), 0.97);
  EXPECT_GT(share_right(found.of_right, {500, 100}, 80.0, -kFarMove), 0.97);
  EXPECT_LE(found.least, -kFarMove);
  EXPECT_GE(found.most, -kNearMove);
  EXPECT_TRUE(std::all_of(found.of_left.data.begin(), found.of_left.data.end(), [](float d) { return std::isfinite(d); }));
  EXPECT_EQ(warnings_, "");
}

TEST_F(StereoDepth, hidden_parts_get_the_background) {
  const StereoDisparity found = disparity_of_pair(shot(0, {}), shot(1, {}), "pair", context_);
  // The disc hides this pixel of the wall in the right picture.
  EXPECT_NEAR(found.of_left.pixel(520 - 70 - 5, 370)[0], -kFarMove, 1.0);
}

TEST_F(StereoDepth, warns_of_rows_that_differ) {
  disparity_of_pair(shot(0, {}), shot(1, moved_about_centre(0.0, 1.0, {0.0, 2.5})), "pair.png", context_);
  EXPECT_THAT(warnings_, HasSubstr("Rows of the two pictures of pair.png differ by 2.5 pixels"));
}

TEST_F(StereoDepth, refuses_pictures_of_different_things) {
  const Image8 plain{640, 480, std::vector<unsigned char>(std::size_t{3} * 640 * 480, 90)};
  EXPECT_THAT(error_message([&] { disparity_of_pair(plain, shot(1, {}), "pair.png", context_); }),
              HasSubstr("pair.png: its two pictures share only 0 points"));
}

}  // namespace
}  // namespace lippmann::test
