// Tests views of a picture that is rendered through lenses of 10.135 pixels. Read with this pitch, the views show each
// object in the right place in all corners of the picture. Read with a pitch of 10 pixels, objects drift by one lens
// every 10 / 0.135 = 74 lenses.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <variant>

#include "job/renders.hpp"
#include "layout/posed_cameras.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann::test {
namespace {

constexpr double kPitchPx = 10.135;
constexpr Vec2i kLenses{160, 24};
constexpr int kViews = 9, kMiddle = 40;

/// Positions of bright squares, in lenses from the top left of the array: one near each corner.
constexpr std::array kCorners{Vec2d(8.5, 5.5), Vec2d(151.5, 5.5), Vec2d(8.5, 18.5), Vec2d(151.5, 18.5)};

class LensPitchRenders : public Renders {
 protected:
  /// Renders white squares on black, and returns the picture of 160x24 lenses with a pitch of 1 mm. The squares are 3 lenses
  /// wide and lie `behind_mm` behind the array. Rays through the middle of the elemental images meet at the viewing distance.
  std::filesystem::path render_squares(double behind_mm, const std::string& viewing_distance = "inf") {
    std::ofstream scene(dir_ / "squares.nff");
    // The field of view makes the plane of the array 24 units high, so that a unit is a lens.
    scene << "v\nfrom 0 0 100\nat 0 0 0\nup 0 1 0\nangle " << 2.0 * degrees(std::atan(0.12))
          << "\nhither 0.1\nresolution 512 512\n"
          << "b 0 0 0\nl 0 0 100\nf 1 1 1 1 0 0 0 0\n";
    for (const Vec2d corner : kCorners) {
      const Vec2d centre(corner.x - 0.5 * kLenses.x, 0.5 * kLenses.y - corner.y);
      scene << "p 4\n";
      for (const Vec2d off : {Vec2d(-1.5, -1.5), Vec2d(1.5, -1.5), Vec2d(1.5, 1.5), Vec2d(-1.5, 1.5)})
        scene << centre.x + off.x << ' ' << centre.y + off.y << ' ' << -behind_mm << '\n';
    }
    scene.close();
    const std::string folder = fmt::format("behind-{}-{}", behind_mm, viewing_distance);
    render(job((dir_ / "squares.nff").string(), folder,
               {{"optics", "microlens"},
                {"lenses", "160x24"},
                {"lens-pixels", "10.135"},
                {"viewing-distance", viewing_distance},
                {"fit-depth", "false"},
                {"frames", "0"},
                {"spp", "1"}}));
    return dir_ / folder / "frame_0000.png";
  }
};

/// Reads the elemental images of a display as 9x9 views, with a pitch in pixels.
LightField views_with_pitch(const std::filesystem::path& picture, double pitch_px) {
  FormatOptions options;
  options.views = ViewGrid{kViews, kViews};
  options.plenoptic =
      PlenopticCalibration{.grid = lens_grid(pitch_px, 0.0, Vec2d(0.5 * pitch_px), LensArrangement::kSquare), .inverted = true};
  return find_format("plenoptic", "from").read(picture, options);
}

/// Returns the centroid of the light in each quarter of a view, in lenses from the top left. The order is that of kCorners.
std::array<Vec2d, 4> squares_in(const LightField& field, int view) {
  const Image8 picture = std::get<Image8>(view_of(field, view));
  std::array<Vec2d, 4> found{};
  std::array<double, 4> sums{};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t quarter = (2 * x >= picture.width ? 1 : 0) + (2 * y >= picture.height ? 2 : 0);
      const double code = picture.rgb[3 * (static_cast<std::size_t>(y) * picture.width + x)];
      found[quarter] += code * (Vec2d(x, y) + 0.5);
      sums[quarter] += code;
    }
  for (std::size_t i = 0; i < 4; ++i) found[i] /= sums[i];
  return found;
}

/// Expects the squares `behind_mm` behind the array in their places in all views.
void expect_in_place(const LightField& field, double behind_mm) {
  ASSERT_EQ(field.view_size, kLenses);
  // Pixels are 1 / 10.135 mm wide and lie 2.0054 mm behind the lenses, where the viewing zone of 28 degrees is one lens wide.
  const double lenses_per_view = behind_mm / (kPitchPx * 2.0054);
  for (int view = 0; view < field.grid.count(); ++view) {
    const std::array<Vec2d, 4> found = squares_in(field, view);
    // Objects behind the array move with the eye. The eyes of row 0 are the lowest.
    const Vec2d eye(view % kViews - kViews / 2, kViews / 2 - view / kViews);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2d expected = kCorners[i] + lenses_per_view * eye;
      EXPECT_NEAR(found[i].x, expected.x, 0.5) << view << " corner " << i;
      EXPECT_NEAR(found[i].y, expected.y, 0.5) << view << " corner " << i;
    }
  }
}

TEST_F(LensPitchRenders, views_do_not_drift_from_corner_to_corner) {
  for (const double behind_mm : {0.0, 10.0}) expect_in_place(views_with_pitch(render_squares(behind_mm), kPitchPx), behind_mm);
}

TEST_F(LensPitchRenders, report_states_the_lens_grid) {
  const OpenedLightField opened = open_light_field(render_squares(10.0), "", {.views = ViewGrid{kViews, kViews}});
  EXPECT_EQ(opened.format, "plenoptic");
  expect_in_place(opened.field, 10.0);
  EXPECT_FALSE(opened.field.cameras) << "parallel projections";
}

/// The plane of the array is 24 units high at 100 units from the scene's camera, so at 100 mm a unit is a millimetre. Views
/// have one sample per lens, so the error of a centroid is up to half a lens. The panel consists of whole pixels,
/// which adds 0.05 lenses.
TEST_F(LensPitchRenders, report_states_the_cameras) {
  const LightField field = open_light_field(render_squares(10.0, "100"), "", {.views = ViewGrid{kViews, kViews}}).field;
  ASSERT_TRUE(field.cameras);
  EXPECT_NEAR(field.cameras->distance_mm, 100.0, 1e-3);
  const std::vector<PosedCamera> cameras = posed_cameras(field, "a");
  for (int view = 0; view < field.grid.count(); ++view) {
    const std::array<Vec2d, 4> found = squares_in(field, view);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3d centre(kCorners[i].x - 0.5 * kLenses.x, 0.5 * kLenses.y - kCorners[i].y, -10.0);
      const Vec2d error = found[i] - projected(cameras[static_cast<std::size_t>(view)], centre);
      EXPECT_LT(std::max(std::abs(error.x), std::abs(error.y)), 0.55) << view << " corner " << i;
    }
  }
}

TEST_F(LensPitchRenders, wrong_pitch_drifts_one_lens_per_74) {
  const LightField field = views_with_pitch(render_squares(0.0), 10.0);
  for (int view = 0; view < field.grid.count(); ++view) {
    const std::array<Vec2d, 4> found = squares_in(field, view);
    // 143 lenses of 10.135 pixels are 1449.3 pixels, which are read as 144.93 lenses of 10 pixels.
    EXPECT_NEAR(found[1].x - found[0].x, 143.0 + 143.0 / 74.0, 0.3) << view;
    EXPECT_NEAR(found[3].x - found[2].x, 143.0 + 143.0 / 74.0, 0.3) << view;
  }
}

}  // namespace
}  // namespace lippmann::test
