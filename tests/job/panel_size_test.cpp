#include "job/panel_size.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

void expect_size(const RenderParams& params, int width, int height, float lens_pixels) {
  const PanelSize size = panel_size(params, {0, 0});
  EXPECT_EQ(size.width, width);
  EXPECT_EQ(size.height, height);
  EXPECT_EQ(size.lens_pixels, lens_pixels);
}

std::string refusal(const RenderParams& params) {
  try {
    panel_size(params, {0, 0});
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), 2);
    return error.what();
  }
  return "accepted";
}

TEST(PanelSize, default_is_64_lenses_of_8_pixels) { expect_size({}, 512, 512, 8.0f); }

TEST(PanelSize, lenses_alone_keep_8_pixels_each) {
  RenderParams params;
  params.optics.lenses = {100, 0};
  expect_size(params, 800, 800, 8.0f);
  params.optics.lenses = {100, 50};
  expect_size(params, 800, 400, 8.0f);
}

TEST(PanelSize, size_and_lenses_give_lens_pixels) {
  RenderParams params;
  params.optics.size = {1378, 300};
  params.optics.lenses = {100, 0};
  expect_size(params, 1378, 300, 13.78f);
}

TEST(PanelSize, size_and_fractional_lens_pixels_are_kept) {
  RenderParams params;
  params.optics.size = {3840, 2160};
  params.optics.lens_pixels = {13.776f, 0.0f};
  expect_size(params, 3840, 2160, 13.776f);
}

TEST(PanelSize, fractional_lens_pixels_round_the_panel) {
  RenderParams params;
  params.optics.lenses = {10, 0};
  params.optics.lens_pixels = {13.776f, 0.0f};
  expect_size(params, 138, 138, 13.776f);
}

TEST(PanelSize, three_values_must_agree) {
  RenderParams params;
  params.optics.lenses = {64, 0};
  params.optics.lens_pixels = {8.0f, 0.0f};
  params.optics.size = {512, 100};
  expect_size(params, 512, 100, 8.0f);
  params.optics.size = {500, 100};
  EXPECT_THAT(refusal(params), HasSubstr("64 lenses of 8 pixels make 512"));
}

TEST(PanelSize, microlens_default_is_64x64_lenses) {
  RenderParams params;
  params.optics.kind = OpticsKind::kMicrolens;
  expect_size(params, 512, 512, 8.0f);
  params.optics.lenses = {64, 32};
  params.optics.lens_pixels = {10.0f, 10.0f};
  expect_size(params, 640, 320, 10.0f);
}

TEST(PanelSize, hexagonal_rows_are_closer) {
  RenderParams params;
  params.optics.kind = OpticsKind::kMicrolens;
  params.optics.packing = LensPacking::kHexagonal;
  expect_size(params, 512, 443, 8.0f);  // rows of hexagonal lenses are sqrt(3) / 2 pitches apart: 512 * 0.8660 = 443.4
}

TEST(PanelSize, oblong_lenslets_are_refused) {
  RenderParams params;
  params.optics.kind = OpticsKind::kMicrolens;
  params.optics.lens_pixels = {8.0f, 10.0f};
  EXPECT_THAT(refusal(params), HasSubstr("lens-pixels: "));
}

TEST(PanelSize, quilt_must_divide_into_its_views) {
  RenderParams params;
  params.optics.kind = OpticsKind::kMultiview;
  expect_size(params, 8 * 256, 6 * 256, 0.0f);
  params.optics.views = {5, 9};
  params.optics.size = {4096, 4096};
  EXPECT_THAT(refusal(params), HasSubstr("for example 4095x4095"));
}

TEST(PanelSize, single_view_has_the_scenes_resolution) {
  RenderParams params;
  params.optics.kind = OpticsKind::kSingle;
  EXPECT_EQ(panel_size(params, {640, 480}).width, 640);
  EXPECT_EQ(panel_size(params, {0, 0}).width, 512);
  params.optics.size = {100, 50};
  EXPECT_EQ(panel_size(params, {640, 480}).height, 50);
}

TEST(PanelSize, too_many_pixels_are_refused) {
  RenderParams params;
  params.optics.size = {50000, 50000};
  EXPECT_THAT(refusal(params), HasSubstr("2500000000 pixels; accepted: 1 to 2147483647 pixels"));
  params.optics.size = {0, 0};
  params.optics.lenses = {1 << 20, 0};
  params.optics.lens_pixels = {1048576.0f, 0.0f};
  EXPECT_THAT(refusal(params), HasSubstr("accepted: 1 to 2147483647 pixels"));
  params = {};
  params.optics.size = {100000, 1};
  EXPECT_THAT(refusal(params), HasSubstr("at most 65536 a side"));
}

TEST(PanelSize, parameters_of_other_optics_are_refused) {
  RenderParams params;
  params.optics.kind = OpticsKind::kSingle;
  params.optics.lenses = {64, 0};
  EXPECT_THAT(refusal(params),
              HasSubstr("lenses: has no effect on this kind of optics; accepted: `optics` lenticular, microlens or plenoptic"));
  params = {};
  params.optics.views = {8, 6};
  EXPECT_THAT(refusal(params), HasSubstr("views: "));
  params = {};
  params.optics.kind = OpticsKind::kMicrolens;
  params.optics.slant_deg = 10.0f;
  EXPECT_THAT(refusal(params), HasSubstr("slant: "));
}

TEST(PanelSize, more_lenses_than_pixels_are_refused) {
  RenderParams params;
  params.optics.size = {32, 32};
  params.optics.lenses = {64, 0};
  EXPECT_THAT(refusal(params), HasSubstr("at most one lens per pixel"));
}

}  // namespace
}  // namespace lippmann
