#include "align/align_pictures.hpp"

#include <gmock/gmock.h>

#include <string>

#include "align/align_module_file.hpp"
#include "align/row_of_cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/image/picture_file.hpp"
#include "support/error_message.hpp"
#include "support/folder_files.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// Transforms of five hand-held cameras in a row, relative to the third one.
std::vector<Similarity> hand_held() {
  return {moved_about_centre(0.8, 1.02, {9.0, -6.5}),
          moved_about_centre(-1.5, 0.985, {-4.0, 8.25}),
          {},
          moved_about_centre(0.37, 1.004, {14.5, 3.0}),
          moved_about_centre(2.0, 0.99, {-7.0, -9.75})};
}

void write_shots(const fs::path& folder, const std::vector<Similarity>& cameras) {
  fs::create_directories(folder);
  for (std::size_t i = 0; i < cameras.size(); ++i)
    write_picture(folder / (std::to_string(i + 1) + ".png"),
                  shot(static_cast<int>(i) - static_cast<int>(cameras.size() / 2), cameras[i]));
}

struct AlignedShots {
  TempDir dir;
  AlignedPictures made;
  std::string warnings;

  AlignedShots() {
    write_shots(dir / "in", hand_held());
    Context context;
    context.threads = 1;
    context.warn = [this](std::string_view text) { warnings += text; };
    made = align_pictures({dir / "in", dir / "out", kSceneFocus}, context);
  }
};

const AlignedShots& aligned_shots() {
  static const AlignedShots shots;
  return shots;
}

class Align : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_align_module_installed()) GTEST_SKIP() << "the module for OpenCV is not built: libopencv-calib3d-dev is missing";
  }

  void shoot(const std::vector<Similarity>& cameras) { write_shots(dir_ / "in", cameras); }

  AlignedPictures align(std::optional<Vec2d> focus, int threads = 1, const std::string& out = "out") {
    Context context;
    context.threads = threads;
    context.warn = [this](std::string_view text) { warnings_ += text; };
    return align_pictures({dir_ / "in", dir_ / out, focus}, context);
  }

  std::string error() {
    return error_message([&] { align({}); });
  }

  TempDir dir_;
  std::string warnings_;
};

TEST_F(Align, recovers_rotations_scales_and_shifts) {
  const std::vector<Similarity> cameras = hand_held();
  const AlignedPictures& made = aligned_shots().made;
  ASSERT_EQ(made.pictures.size(), 5u);
  const Vec2d centre = 0.5 * Vec2d(kSceneSize);
  for (int i = 0; i < 5; ++i) {
    const Similarity& found = made.pictures[i].moved;
    EXPECT_NEAR(found.turn_deg(), cameras[i].turn_deg(), 0.01) << i;
    EXPECT_NEAR(found.scale(), cameras[i].scale(), 2e-4) << i;
    const Vec2d wanted = cameras[i](centre) - Vec2d(kFocusMove * (i - 2), 0.0);
    EXPECT_NEAR(found(centre).x, wanted.x, 0.1) << i;
    EXPECT_NEAR(found(centre).y, wanted.y, 0.1) << i;
    EXPECT_LT(made.pictures[i].residual_px, 0.5) << i;
  }
  EXPECT_EQ(aligned_shots().warnings, "");
}

TEST_F(Align, views_show_the_focus_at_one_place) {
  const AlignedPictures& made = aligned_shots().made;
  ASSERT_GT(made.size.x, 560);
  ASSERT_GT(made.size.y, 400);
  const Vec2d from_window = kSceneFocus - made.focus;
  for (int i = 0; i < 5; ++i) {
    const Image8 view = std::get<Image8>(read_picture(aligned_shots().dir / ("out/view_00" + std::to_string(i) + ".png")));
    ASSERT_EQ(Vec2i(view.width, view.height), made.size);
    double worst = 0.0, sum = 0.0;
    int count = 0;
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        const Vec2d place = Vec2d(x + 0.5, y + 0.5) + from_window;
        if (glm::length(place - kSceneFocus) > 80.0) continue;
        const double off =
            std::abs(view.rgb[3 * (static_cast<std::size_t>(y) * view.width + x)] - 20.0 - 215.0 * texture_at(place, 21));
        worst = std::max(worst, off), sum += off, ++count;
      }
    // Differences are in codes. Rounding the input and the output adds up to 1/2 each, and a misalignment of 0.1 px adds
    // about 1.
    EXPECT_LT(sum / count, 1.5) << i;
    EXPECT_LT(worst, 12.0) << i;
  }
}

TEST_F(Align, parallax_matches_discs_and_wall) {
  const AlignedPictures& made = aligned_shots().made;
  EXPECT_NEAR(made.parallax.near_px, 4 * (kFocusMove - kNearMove), 0.6);
  EXPECT_NEAR(made.parallax.far_px, 4 * (kFocusMove - kFarMove), 0.6);
  const ShownParallax shown = shown_parallax(load_display("lpi=60 dpi=600 paper=100x50mm"), {1000, 600}, 5);
  EXPECT_NEAR(shown.mm_per_px, 0.1, 1e-4) << "the picture fills the width of the paper";
  EXPECT_NEAR(shown.lens_mm, 25.4 / 60, 1e-6);
  EXPECT_EQ(shown.views, 5) << "with ten pixels below a lens";
}

TEST_F(Align, tilted_slider_is_levelled) {
  std::vector<Similarity> cameras;
  for (int i = 0; i < 5; ++i) cameras.push_back(moved_about_centre(1.2, 1.0, {0.0, 0.0}));
  shoot(cameras);
  const AlignedPictures made = align(kSceneFocus);
  for (const AlignedPicture& picture : made.pictures) EXPECT_NEAR(picture.moved.turn_deg(), 1.2, 0.02);
}

TEST_F(Align, pictures_in_place_keep_their_pixels) {
  shoot(std::vector<Similarity>(3));
  const AlignedPictures made = align(kSceneFocus);
  const Image8 in = std::get<Image8>(read_picture(dir_ / "in/2.png")),
               out = std::get<Image8>(read_picture(dir_ / "out/view_001.png"));
  EXPECT_EQ(made.pictures[1].moved, Similarity{});
  ASSERT_GT(out.width, 600);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      ASSERT_EQ(out.rgb[3 * (static_cast<std::size_t>(y) * out.width + x)],
                in.rgb[3 * (static_cast<std::size_t>(y + made.corner.y) * in.width + x + made.corner.x)])
          << x << " " << y;
}

TEST_F(Align, does_not_depend_on_threads) {
  shoot(hand_held());
  align({}, 1, "one");
  align({}, 3, "three");
  EXPECT_EQ(files_in(dir_ / "one", ".png"), files_in(dir_ / "three", ".png"));
}

TEST_F(Align, warns_of_a_focus_without_texture) {
  shoot(hand_held());
  for (int i = 1; i <= 5; ++i) {
    const fs::path path = dir_ / ("in/" + std::to_string(i) + ".png");
    Image8 picture = std::get<Image8>(read_picture(path));
    for (int y = 0; y < 70; ++y) std::fill_n(picture.rgb.begin() + 3 * y * 640, 3 * 640, 90);
    write_picture(path, picture);
  }
  align(Vec2d(300.0, 30.0));
  EXPECT_THAT(warnings_, AllOf(HasSubstr("4 pictures do not show the point 300,30 of 3.png"), HasSubstr("`focus`")));
}

TEST_F(Align, refuses_what_cannot_be_aligned) {
  shoot({Similarity{}});
  EXPECT_THAT(error(), HasSubstr("contains only one picture"));
  Image8 plain{640, 480, {}};
  plain.rgb.assign(std::size_t{3} * 640 * 480, 128);
  write_picture(dir_ / "in/2.png", plain);
  EXPECT_THAT(error(), AllOf(HasSubstr("2.png"), HasSubstr("shares only 0 points with 1.png"), HasSubstr("texture")));
  write_picture(dir_ / "in/2.png", Image8{2, 1, {1, 2, 3, 4, 5, 6}});
  EXPECT_THAT(error(), HasSubstr("2x1"));
  write_picture(dir_ / "in/2.png", shot(1, {}));
  EXPECT_THAT(error_message([&] { align(Vec2d(700.0, 9.0)); }), HasSubstr("focus: 700,9 lies outside the pictures"));
  EXPECT_THAT(error_message([&] { align({}, 1, "in"); }), HasSubstr("is the input folder"));
  EXPECT_FALSE(fs::exists(dir_ / "out"));
}

}  // namespace
}  // namespace lippmann::test
