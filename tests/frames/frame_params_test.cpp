#include "lippmann/frames/frame_params.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

const Sampling kPaths{.integrator = Integrator::kPath, .spp = 32};

std::string refused(const FrameParams& params) {
  try {
    check(params);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_FALSE(error.accepted().empty());
    return error.where();
  }
  return {};
}

TEST(FrameParams, auto_copies_whitted_pixels) { EXPECT_STREQ(name_of(resolved_reuse({})), "copy"); }

TEST(FrameParams, auto_traces_all_paths_alpha_and_layers) {
  for (const Sampling& sampling : {kPaths, Sampling{.transparent = true}, Sampling{.aov = {Aov::kDepth}}})
    EXPECT_STREQ(name_of(resolved_reuse({sampling, {}})), "none");
}

TEST(FrameParams, a_chosen_kind_is_kept) {
  for (const Reuse& reuse : {Reuse(TraceAll{}), Reuse(CopySettled{}), Reuse(Interpolate{})})
    EXPECT_EQ(resolved_reuse({kPaths, reuse}).index(), reuse.index());
}

TEST(FrameParams, unsupported_sampling_is_refused) {
  EXPECT_EQ(refused({kPaths, CopySettled{}}), "reuse");
  EXPECT_EQ(refused({{.aov = {Aov::kDepth}}, CopySettled{}}), "reuse");
  EXPECT_EQ(refused({kPaths, Interpolate{}}), "reuse");
  EXPECT_EQ(refused({{.transparent = true}, Interpolate{}}), "transparent");
  EXPECT_EQ(refused({{.aov = {Aov::kDepth}}, Interpolate{}}), "aov");
  EXPECT_EQ(refused({{.angular_filter = AngularFilter::kBox}, Interpolate{}}), "angular-filter");
}

TEST(FrameParams, invalid_blur_is_refused) {
  EXPECT_EQ(refused({{.spp = 4, .lens = {.aperture_mm = -1.0f}}, TraceAll{}}), "aperture");
  EXPECT_EQ(refused({{.spp = 4, .lens = {.f_number = -1.0f}}, TraceAll{}}), "f-number");
  EXPECT_EQ(refused({{.spp = 4, .lens = {.aperture_mm = 1.0f, .f_number = 2.0f}}, TraceAll{}}), "f-number");
  EXPECT_EQ(refused({{.spp = 4, .lens = {.focal_plane_mm = 10.0f}}, TraceAll{}}), "focal-plane");
  EXPECT_EQ(refused({{.spp = 4, .lens = {.aperture_mm = 1.0f}}, Interpolate{}}), "aperture");
  EXPECT_EQ(refused({{.spp = 4, .shutter = 1.5f}, TraceAll{}}), "shutter");
  EXPECT_EQ(refused({{.spp = 1, .shutter = 0.5f}, TraceAll{}}), "shutter");
  for (const Reuse& reuse : {Reuse(CopySettled{}), Reuse(Interpolate{})})
    EXPECT_EQ(refused({{.spp = 4, .shutter = 0.5f}, reuse}), "shutter");
  EXPECT_EQ(refused({{.spp = 4, .shutter = 0.5f}, {}}), "");
  EXPECT_STREQ(name_of(resolved_reuse({{.spp = 4, .shutter = 0.5f}, {}})), "none");
}

TEST(FrameParams, a_lens_needs_views_samples_and_focus) {
  Optics quilt, sheet;
  quilt.model = MultiView{.distance_mm = 300.0f};
  sheet.model = LenticularSheet{};
  const auto refused_by = [](const Optics& optics, int spp, float focal_plane) {
    try {
      check({{.spp = spp, .lens = {.aperture_mm = 4.0f, .focal_plane_mm = focal_plane}}, TraceAll{}}, optics);
    } catch (const Error& error) {
      return error.where();
    }
    return std::string();
  };
  EXPECT_EQ(refused_by(quilt, 4, 100.0f), "");
  EXPECT_EQ(refused_by(quilt, 1, 100.0f), "aperture");
  EXPECT_EQ(refused_by(quilt, 4, 300.0f), "focal-plane");
  EXPECT_EQ(refused_by(sheet, 4, 0.0f), "aperture");
}

TEST(FrameParams, invalid_numbers_are_refused) {
  EXPECT_EQ(refused({{.spp = -1}, TraceAll{}}), "spp");
  EXPECT_EQ(refused({{.max_depth = -1}, TraceAll{}}), "max-depth");
  for (const float light : {-1.0f, std::nanf("")})
    EXPECT_EQ(refused({{.clamp_indirect = light}, TraceAll{}}), "clamp-indirect");
  for (const int every : {0, -4}) {
    EXPECT_EQ(refused({{}, Interpolate{.keyframes = every}}), "keyframes");
    EXPECT_EQ(refused({{}, CopySettled{.keyframes = every}}), "keyframes");
  }
  EXPECT_EQ(refused({{}, Interpolate{.keyframes = 1}}), "");
  for (const double none : {0.0, -5.0, std::nan(""), HUGE_VAL})
    EXPECT_EQ(refused({{}, Interpolate{.min_psnr_db = none}}), "min-psnr");
}

TEST(FrameParams, options_that_break_min_psnr_are_refused) {
  EXPECT_EQ(refused({{}, Interpolate{.min_psnr_db = 50.0}}), "");
  EXPECT_EQ(refused({{}, Interpolate{.min_psnr_db = 50.0, .fill = MissedFill::kRetrace}}), "fill");
  EXPECT_EQ(refused({{}, Interpolate{.min_psnr_db = 50.0, .halving = true}}), "halving");
  EXPECT_EQ(refused({{}, Interpolate{.min_psnr_db = 50.0, .no_z_buffer = true}}), "no-z-buffer");
}

TEST(FrameParams, layers_of_paths_are_refused_without_them) {
  EXPECT_EQ(refused({{.aov = {Aov::kIndirect}}, TraceAll{}}), "aov");
  EXPECT_EQ(refused({{.integrator = Integrator::kPath, .aov = {Aov::kIndirect}}, TraceAll{}}), "");
}

TEST(FrameParams, default_samples_are_16_or_one) {
  EXPECT_EQ(samples_per_pixel({.integrator = Integrator::kPath}), 16);
  EXPECT_EQ(samples_per_pixel({}), 1);
  EXPECT_EQ(samples_per_pixel({.integrator = Integrator::kPath, .spp = 5}), 5);
}

TEST(FrameParams, paths_are_denoised_from_two_samples) {
  EXPECT_TRUE(is_denoised({.integrator = Integrator::kPath}));
  EXPECT_TRUE(is_denoised({.integrator = Integrator::kPath, .spp = 2}));
  EXPECT_FALSE(is_denoised({.integrator = Integrator::kPath, .spp = 1}));
  EXPECT_FALSE(is_denoised({.integrator = Integrator::kPath, .denoise = Denoise::kNone}));
  EXPECT_FALSE(is_denoised({.spp = 16}));
}

TEST(FrameParams, a_box_filter_needs_views_and_samples) {
  Optics quilt, sheet;
  quilt.model = MultiView{};
  sheet.model = LenticularSheet{};
  const auto refused_by = [](const Optics& optics, int spp) {
    try {
      check({{.spp = spp, .angular_filter = AngularFilter::kBox}, TraceAll{}}, optics);
    } catch (const Error& error) {
      return error.where();
    }
    return std::string();
  };
  EXPECT_EQ(refused_by(quilt, 4), "");
  EXPECT_EQ(refused_by(quilt, 1), "angular-filter");
  EXPECT_EQ(refused_by(sheet, 4), "angular-filter");
}

}  // namespace
}  // namespace lippmann
