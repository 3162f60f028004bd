// Views resolved from the samples of their neighbours: where samples land, which are hidden, and what pixels become of them.
#include "bench/view_resolver.hpp"

#include <gtest/gtest.h>

namespace lippmann::bench {
namespace {

constexpr int kViewSide = 16;
constexpr float kSameSurface = 0.01f;

/// What a view sees at a place: a colour, how far it moves with the eye, which surface it is.
struct Seen {
  float light, shift;
  std::int32_t surface;
  bool own = false;
};

/// A view from `eye_mm` with its samples at (dx, dy) in every pixel. scene(x): what is seen there from eye 0.
template <class SceneOf>
ViewSamples view_from(double eye_mm, float dx, float dy, const SceneOf& scene_of) {
  ViewSamples view{.width = kViewSide, .height = kViewSide, .eye_mm = eye_mm};
  for (int y = 0; y < kViewSide; ++y)
    for (int x = 0; x < kViewSide; ++x) {
      const float px = static_cast<float>(x) + dx;
      const Seen seen = scene_of(px, static_cast<float>(eye_mm));
      view.x.push_back(px), view.y.push_back(static_cast<float>(y) + dy);
      view.shift.push_back(seen.shift), view.surface.push_back(seen.surface), view.own.push_back(seen.own ? 1 : 0);
      view.rgb.insert(view.rgb.end(), 3, seen.light);
    }
  return view;
}

/// A dark and a bright half of one plane, in which points move by 1 pixel a mm, with the edge at 8.25 as seen from eye 0.
Seen edge(float x, float eye_mm) { return x - eye_mm < 8.25f ? Seen{0.0f, 1.0f, 0} : Seen{1.0f, 1.0f, 1}; }

/// Eyes at 0, 1 ... 4 mm, each with its samples at another place.
template <class SceneOf>
std::vector<ViewSamples> five_views(const SceneOf& scene_of) {
  constexpr float kAcross[] = {0.1f, 0.3f, 0.5f, 0.7f, 0.9f}, kDown[] = {0.5f, 0.9f, 0.1f, 0.7f, 0.3f};
  std::vector<ViewSamples> views;
  for (int v = 0; v < 5; ++v) views.push_back(view_from(v, kAcross[v], kDown[v], scene_of));
  return views;
}

float pixel(const Image& picture, int x) { return picture.pixel(x, 8)[0]; }

// As seen from eye 2 the edge is at 10.25: pixel 10 is 3/4 bright. Its five samples are at 10.1 ... 10.9.
TEST(ViewResolver, samples_of_neighbours_land_beside_an_edge_and_tell_where_it_is) {
  const std::vector<ViewSamples> views = five_views(edge);
  const auto at = [&](Resolver how) { return pixel(resolve_view(views, 2, 2, kSameSurface, how), 10); };
  EXPECT_EQ(at(Resolver::kOwn), 1.0f);
  EXPECT_FLOAT_EQ(at(Resolver::kCount), 0.8f);
  EXPECT_NEAR(at(Resolver::kVoronoi), 0.75f, 0.13f);
  EXPECT_NEAR(at(Resolver::kLines), 0.75f, 0.15f);
  for (const Resolver how : {Resolver::kCount, Resolver::kVoronoi, Resolver::kLines}) {
    const Image picture = resolve_view(views, 2, 2, kSameSurface, how);
    EXPECT_FLOAT_EQ(pixel(picture, 7), 0.0f);
    EXPECT_FLOAT_EQ(pixel(picture, 13), 1.0f);
  }
}

// An upright edge at a quarter of the pixel, with samples on both sides of it in every row: the line is found exactly.
TEST(ViewResolver, a_line_halves_the_gap_between_the_samples_of_both_sides) {
  std::vector<ViewSamples> views{view_from(0.0, 0.2f, 0.5f, edge), view_from(1.0, 0.3f, 0.5f, edge)};
  const Image picture = resolve_view(views, 1, 1, kSameSurface, Resolver::kLines);
  EXPECT_NEAR(pixel(picture, 9), 0.75f, 1e-3f);  // the line is at 0.25
}

// A near strip of 3 pixels that stands still as the eye moves, before a background that moves: what views see of the background
// where this one sees the strip must not shine through.
TEST(ViewResolver, what_the_view_cannot_see_is_dropped) {
  const auto strip = [](float x, float) { return x >= 6.0f && x < 9.0f ? Seen{0.0f, 0.0f, 0} : Seen{1.0f, 1.0f, 1}; };
  const Image picture = resolve_view(five_views(strip), 2, 2, kSameSurface, Resolver::kCount);
  EXPECT_EQ(pixel(picture, 7), 0.0f);
}

// The strip begins in the middle of pixel 6, as four samples of the view's own tell: background that another view lands in the
// strip's half is hidden, though the pixel shows background, too. It has two samples of either, and the strip of the other
// view.
TEST(ViewResolver, four_samples_of_the_view_tell_what_is_hidden_within_a_pixel) {
  const auto strip = [](float x, float) { return x >= 6.5f && x < 9.0f ? Seen{0.0f, 0.0f, 0} : Seen{1.0f, 1.0f, 1}; };
  std::vector<ViewSamples> views{view_from(0.0, 0.75f, 0.75f, strip)};
  for (const float dx : {0.25f, 0.75f})
    for (const float dy : {0.25f, 0.75f}) views.push_back(view_from(1.0, dx, dy, strip));
  EXPECT_FLOAT_EQ(pixel(resolve_view(views, 1, 4, kSameSurface, Resolver::kCount), 6), 0.4f);
}

// A mirror that looks different from every eye keeps the view's own light, and its edge is known from all.
TEST(ViewResolver, light_that_depends_on_the_view_stays_in_it) {
  const auto mirror = [](float x, float eye_mm) {
    const bool is_mirror = x - eye_mm >= 8.25f;
    return is_mirror ? Seen{0.2f * eye_mm, 1.0f, 1, true} : Seen{1.0f, 1.0f, 0, false};
  };
  const Image picture = resolve_view(five_views(mirror), 2, 2, kSameSurface, Resolver::kCount);
  EXPECT_FLOAT_EQ(pixel(picture, 12), 0.4f);
  EXPECT_FLOAT_EQ(pixel(picture, 10), 0.8f * 0.4f + 0.2f * 1.0f);
}

}  // namespace
}  // namespace lippmann::bench
