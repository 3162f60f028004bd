#include "replay/depth_views.hpp"

#include <gmock/gmock.h>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// Tolerance of positions in pixels. Interpolation gives each of the four pixels around a position a weight of at least
/// 1e-6.
constexpr double kWeights = 1e-5;

/// A plane at the depth `z` mm, with a bright column at x = `lit`. The screen has 40 x 4 pixels of 1 mm, and is seen
/// from 100 mm.
LightField plane(int lit, float z) {
  LightField field;
  field.grid = {1, 1}, field.view_size = {40, 4}, field.aspect = 10.0;
  Image colours(40, 4, 3);
  for (int y = 0; y < 4; ++y) colours.pixel(lit, y)[0] = 1.0f;
  field.stack = colours;
  field.depth = Image(40, 4, 1);
  std::fill(field.depth->data.begin(), field.depth->data.end(), z);
  field.cameras = {100.0, Vec2d(1.0), Vec2d(20, 2), {{0, 0}}};
  return field;
}

/// Eyes 20 mm apart at a distance of 100 mm, with the slopes -0.2, 0 and 0.2.
Optics three_eyes() {
  MultiView eyes{3, 1};
  eyes.baseline_mm = 20.0f, eyes.distance_mm = 100.0f;
  return {{120, 4, 1.0f}, eyes};
}

DepthViews shown(const LightField& source, const Optics& optics = three_eyes(), double scale = 1.0) {
  const ThreadPool pool(1);
  return views_from_depth(source, optics, scale, pool);
}

double lit_at(const DepthViews& made, int view) {
  const Image image = std::get<Image>(view_of(made.field, view));
  double sum = 0.0, weight = 0.0;
  for (int x = 0; x < image.width; ++x) sum += x * image.pixel(x, 1)[0], weight += image.pixel(x, 1)[0];
  return sum / weight;
}

TEST(DepthViews, plane_shifts_by_its_disparity) {
  // Disparity: z / (1 - z / 100) = -25 / (1 + 1/4) = -20 mm. The eye with slope 0.2 sees the plane 0.2 * 20 = 4 mm
  // further right, the eye with slope -0.2 sees it 4 mm further left.
  const DepthViews behind = shown(plane(20, -25.0f));
  EXPECT_NEAR(lit_at(behind, 0), 16.0, kWeights);
  EXPECT_NEAR(lit_at(behind, 1), 20.0, kWeights);
  EXPECT_NEAR(lit_at(behind, 2), 24.0, kWeights);
  // Disparity: 20 / (1 - 1/5) = 25 mm. The plane moves by 0.2 * 25 = 5 mm the other way.
  const DepthViews before = shown(plane(20, 20.0f));
  EXPECT_NEAR(lit_at(before, 0), 25.0, kWeights);
  EXPECT_NEAR(lit_at(before, 2), 15.0, kWeights);
}

TEST(DepthViews, screen_plane_stays_without_filled_pixels) {
  const DepthViews made = shown(plane(20, 0.0f));
  for (int view = 0; view < 3; ++view) EXPECT_NEAR(lit_at(made, view), 20.0, kWeights);
  EXPECT_EQ(made.filled_share, 0.0);
}

TEST(DepthViews, middle_view_is_the_picture) {
  LightField source = plane(7, -25.0f);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 40; ++x) {
      std::get<Image>(source.stack).pixel(x, y)[1] = 0.01f * static_cast<float>(x * y);
      source.depth->pixel(x, y)[0] = static_cast<float>(10 - x);
    }
  const Image seen = std::get<Image>(view_of(shown(source).field, 1)), was = std::get<Image>(source.stack);
  for (std::size_t i = 0; i < was.data.size(); ++i) EXPECT_NEAR(seen.data[i], was.data[i], 1e-5) << i;
}

TEST(DepthViews, shifts_of_a_fraction_are_interpolated) {
  // Disparity: -12.5 / 1.125 = -11.1 mm. The shift of 0.2 * 11.1 = 2.22 pixels puts the column between two pixels.
  EXPECT_NEAR(lit_at(shown(plane(20, -12.5f)), 2), 20.0 + 0.2 * 12.5 / 1.125, 1e-5);
}

TEST(DepthViews, disparity_per_slope_is_independent_of_screen) {
  Optics large = three_eyes();
  large.panel.pixel_pitch_mm = 2.0f;
  auto& eyes = std::get<MultiView>(large.model);
  eyes.distance_mm = 400.0f, eyes.baseline_mm = 80.0f;
  EXPECT_NEAR(lit_at(shown(plane(20, -25.0f), large), 2), 24.0, kWeights) << "twice as many mm, as many pixels";
}

TEST(DepthViews, depth_scale_scales_shifts) {
  EXPECT_NEAR(lit_at(shown(plane(20, -25.0f), three_eyes(), 0.5), 2), 22.0, kWeights);
}

/// A blue wall 25 mm behind the screen. A red board in the plane of the screen covers columns 15 to 24.
LightField board() {
  LightField field = plane(0, -25.0f);
  Image& colours = std::get<Image>(field.stack);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 40; ++x) {
      const bool front = x >= 15 && x < 25;
      float* c = colours.pixel(x, y);
      c[0] = front ? 1.0f : 0.0f, c[1] = 0.0f, c[2] = front ? 0.0f : 1.0f;
      field.depth->pixel(x, y)[0] = front ? 0.0f : -25.0f;
    }
  return field;
}

TEST(DepthViews, disoccluded_pixels_are_filled_from_behind) {
  const DepthViews made = shown(board());
  const Image right = std::get<Image>(view_of(made.field, 2));
  for (int x = 0; x < 40; ++x) {
    const bool front = x >= 15 && x < 25;
    EXPECT_EQ(right.pixel(x, 2)[0], front ? 1.0f : 0.0f) << x;
    EXPECT_EQ(right.pixel(x, 2)[2], front ? 0.0f : 1.0f) << x << ": the wall, also where it was hidden";
  }
  // In the right view, 4 columns beside the board show parts of the wall that the source picture does not show, and 4
  // columns at the edge lie outside the source picture. These 8 of 40 columns are filled. The left view is symmetric,
  // so 16 of all 120 columns are filled.
  EXPECT_NEAR(made.filled_share, 16.0 / 120.0, 1e-9);
}

TEST(DepthViews, other_pictures_fill_hidden_parts) {
  LightField left = board(), right = board();
  left.cameras->eyes_mm = {{-20, 0}}, right.cameras->eyes_mm = {{20, 0}};
  Image colours = std::get<Image>(right.stack);
  for (std::size_t i = 1; i < colours.data.size(); i += 3) colours.data[i] = 1.0f;
  right.stack = colours;
  const ThreadPool pool(1);
  const DepthViews made = views_from_depths(std::vector{left, right}, three_eyes(), 1.0, pool);
  EXPECT_EQ(made.filled_share, 0.0);
  const Image middle = std::get<Image>(view_of(made.field, 1));
  // From the left picture to the middle view, the wall moves by 4 pixels. Therefore, 4 columns at the edge and 4
  // columns beside the board come from the right picture.
  for (int x = 0; x < 40; ++x) EXPECT_EQ(middle.pixel(x, 2)[1], x < 4 || (x >= 25 && x < 29) ? 1.0f : 0.0f) << x;
  EXPECT_EQ(std::get<Image>(view_of(made.field, 0)).pixel(26, 2)[1], 0.0f);
  EXPECT_EQ(std::get<Image>(view_of(made.field, 2)).pixel(26, 2)[1], 1.0f);
}

TEST(DepthViews, depth_goes_with_the_views) {
  const DepthViews made = shown(board());
  const Image depth = depth_of(made.field, 2);
  EXPECT_NEAR(depth.pixel(20, 1)[0], 0.0, 1e-4);
  EXPECT_NEAR(depth.pixel(35, 1)[0], -25.0, 1e-4);
}

TEST(DepthViews, threads_do_not_change_the_views) {
  const ThreadPool one(1), four(4);
  const LightField source = board();
  EXPECT_EQ(std::get<Image>(views_from_depth(source, three_eyes(), 1.0, one).field.stack).data,
            std::get<Image>(views_from_depth(source, three_eyes(), 1.0, four).field.stack).data);
}

}  // namespace
}  // namespace lippmann
