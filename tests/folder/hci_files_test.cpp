#include <gtest/gtest.h>

#include <cmath>

#include "folder/frame_files.hpp"
#include "folder/frame_layout.hpp"
#include "formats/hci_parameters.hpp"
#include "image/netpbm.hpp"
#include "image/read_image.hpp"
#include "lippmann/frames/renderer.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/scene/load.hpp"
#include "support/file_bytes.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct View {
  Image colour, disparity;
};

View read_view(const fs::path& folder, int number) {
  const std::string name = std::to_string(number);
  return {read_image(folder / ("input_Cam00" + name + ".png")), read_pfm(folder / ("gt_disp_lowres_Cam00" + name + ".pfm"))};
}

struct Neighbours {
  int x, y;
  float right, below;
};

bool neighbours_of(const Image& image, double x, double y, Neighbours& n) {
  n.x = static_cast<int>(std::floor(x - 0.5)), n.y = static_cast<int>(std::floor(y - 0.5));
  n.right = static_cast<float>(x - 0.5 - n.x), n.below = static_cast<float>(y - 0.5 - n.y);
  return n.x >= 0 && n.y >= 0 && n.x + 1 < image.width && n.y + 1 < image.height;
}

float interpolated(const Image& image, const Neighbours& n, int c) {
  const auto at = [&](int x, int y) { return image.pixel(n.x + x, n.y + y)[c]; };
  return (at(0, 0) * (1 - n.right) + at(1, 0) * n.right) * (1 - n.below) +
         (at(0, 1) * (1 - n.right) + at(1, 1) * n.right) * n.below;
}

struct Agreement {
  double psnr_db = 0.0, visible = 0.0;
};

/// Warps view B to view A by the disparity of A. across, up: distances of the eyes, in baselines. Returns the PSNR in
/// dB of the visible pixels, and their fraction of all pixels. A pixel is visible if the disparities of both views
/// differ by less than 0.1 pixel.
Agreement warp(const View& a, const View& b, int across, int up) {
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < b.colour.height; ++y)
    for (int x = 0; x < b.colour.width; ++x) {
      const float d = *b.disparity.pixel(x, y);
      Neighbours n{};
      if (!neighbours_of(a.colour, x + 0.5 + across * d, y + 0.5 - up * d, n)) continue;
      bool seen = true;
      for (const int i : {0, 1, 2, 3}) seen = seen && std::abs(*a.disparity.pixel(n.x + i % 2, n.y + i / 2) - d) < 0.1f;
      if (!seen) continue;
      ++count;
      for (int c = 0; c < 3; ++c) sum += std::pow(interpolated(a.colour, n, c) - b.colour.pixel(x, y)[c], 2.0);
    }
  return {-10.0 * std::log10(sum / (3.0 * count)), static_cast<double>(count) / (b.colour.width * b.colour.height)};
}

/// Places 3 x 3 eyes at the scene's camera, neighbours about 1 degree apart as seen from the array.
Placement place_grid(const Scene& scene) {
  Optics optics{.panel = {576, 432, 0.125f}, .model = MultiView{.columns = 3, .rows = 3, .baseline_mm = 1.0f}};
  const PlacementWish as_deep_as_it_is{.fit_depth = false};
  const Placement somewhere = place(scene, optics, as_deep_as_it_is);
  auto& grid = std::get<MultiView>(optics.model);
  grid.distance_mm = somewhere.array.viewing_distance / somewhere.placed.units_per_mm;
  grid.baseline_mm = 2.0f * grid.distance_mm * std::tan(radians(0.75f)) / 3.0f;
  return place(scene, optics, as_deep_as_it_is);
}

/// Writes 3 x 3 views of 192 x 144 pixels with disparities of up to 5 pixels.
fs::path make_data_set(const test::TempDir& dir, const char* scene_name) {
  const Context context;
  const Scene scene = load_scene(scene_name, {}, context);
  Renderer renderer(scene, place_grid(scene), {.sampling = {.spp = 16, .aov = {Aov::kDepth}}}, context);
  FramePictures pictures = renderer.frame(0)->pictures;
  pictures.codes = to_codes(pictures.film, scene.encoding);
  PictureParams params;
  params.to = "hci";
  const FrameLayout layout(params, renderer.optics());
  FrameFiles files;
  files.folder = dir.path(), files.names = layout.names();
  files.format = PictureFormat::kPng16, files.encoding = scene.encoding;
  write_light_field_files(files, 0, *layout.light_field(), renderer.optics(), pictures);
  return dir / "frame_0000";
}

TEST(HciFiles, disparity_of_one_view_gives_the_others) {
  const test::TempDir dir;
  const fs::path hci = make_data_set(dir, "gears");
  const View middle = read_view(hci, 4), right = read_view(hci, 5), above = read_view(hci, 1);
  const Agreement across = warp(middle, right, 1, 0), up = warp(middle, above, 0, 1);
  EXPECT_GT(across.visible, 0.8);
  EXPECT_GT(up.visible, 0.8);
  EXPECT_GE(across.psnr_db, 40.0);
  EXPECT_GE(up.psnr_db, 40.0);
  EXPECT_LT(warp(middle, right, -1, 0).psnr_db, across.psnr_db - 4.0) << "the wrong sign is worse";
  EXPECT_LT(warp(middle, above, 0, -1).psnr_db, up.psnr_db - 4.0);
}

TEST(HciFiles, depth_and_disparity_agree_with_the_parameters) {
  const test::TempDir dir;
  const fs::path hci = make_data_set(dir, "teapot");
  const HciParameters p = parse_hci_parameters(test::file_bytes(hci / "parameters.cfg"), "parameters.cfg");
  EXPECT_EQ(p.columns, 3);
  const Image depth = read_pfm(hci / "gt_depth_lowres.pfm"), disparity = read_pfm(hci / "gt_disp_lowres.pfm");
  ASSERT_EQ(depth.width, 192);
  ASSERT_EQ(depth.height, 144);
  EXPECT_EQ(test::file_bytes(hci / "gt_disp_lowres.pfm"), test::file_bytes(hci / "gt_disp_lowres_Cam004.pfm"))
      << "depth of the middle view";
  for (std::size_t i = 0; i < depth.data.size(); ++i)
    ASSERT_NEAR(disparity.data[i], hci_disparity_px(p, static_cast<double>(depth.data[i])), 1e-3) << i;
}

}  // namespace
}  // namespace lippmann
