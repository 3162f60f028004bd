// Tests a row of 9 pixels, each 1 mm wide and seen from far away.
#include "reuse/missed.hpp"

#include <gtest/gtest.h>

#include "reuse/point_images.hpp"

namespace lippmann {
namespace {

using test::KnownMotion;

Optics row_of_pixels() {
  Optics optics;
  optics.panel = {9, 1, 1.0f};
  optics.model = SingleView{1e6f, {0.0f, 0.0f}};
  return optics;
}

struct Row {
  Optics optics = row_of_pixels();
  PointImage previous = test::empty_points(optics.panel), following = previous;
  Image film = Image(9, 1, 3);
  MissedCauses causes;

  void fill(std::uint32_t missed, const std::vector<Affine3f>& from_previous, const std::vector<Affine3f>& from_following) {
    const KnownMotion forth(from_previous), back(from_following), forth_back(inverted(from_previous)),
        back_back(inverted(from_following));
    const Splatter splatter(optics, {});
    const ThreadPool pool(1);
    SplatBuffer a, b;
    splatter.splat(previous, forth.motion, pool, a);
    splatter.splat(following, back.motion, pool, b);
    const SplatSource from_a{previous, forth.motion, a}, from_b{following, back.motion, b};
    std::vector<std::uint32_t> all_missed;
    average(from_a, from_b, nullptr, pool, film, all_missed);
    const std::vector<std::uint32_t> asked{missed};
    ASSERT_NE(std::find(all_missed.begin(), all_missed.end(), missed), all_missed.end());
    const SplatPair pair{from_a, from_b, forth_back.motion, back_back.motion};
    causes = resolve_missed(pair, splatter, ViewSteps(optics, StepsWithin::kView), asked, pool, &film);
  }

  float shown(std::size_t pixel) const { return film.data[3 * pixel]; }

 private:
  static std::vector<Affine3f> inverted(const std::vector<Affine3f>& motions) {
    std::vector<Affine3f> result;
    for (const Affine3f& a : motions) result.push_back(inverse(a));
    return result;
  }
};

const std::vector<Affine3f> kStill{Affine3f{}, Affine3f{}};

TEST(Missed, neighbours_are_weighted_by_inverse_distance) {
  Row row;
  test::set_point(row.previous, 2, 0.0f);
  test::set_point(row.previous, 5, 0.0f);
  row.fill(3, kStill, kStill);
  // A pixel's colour is its number. From pixel 3, pixel 2 is one pixel away (weight 1), and pixel 5 two pixels (weight
  // 1/2).
  EXPECT_FLOAT_EQ(row.shown(3), (2.0f + 0.5f * 5.0f) / 1.5f);
}

TEST(Missed, nearer_neighbours_are_left_out) {
  Row row;
  test::set_point(row.previous, 2, 10.0f, 1);
  test::set_point(row.previous, 5, -10.0f, 0);
  row.fill(3, kStill, kStill);
  EXPECT_EQ(row.shown(3), 5.0f);
}

TEST(Missed, background_fills_disocclusions) {
  Row row;
  test::set_point(row.previous, 2, -1000.0f);
  test::set_point(row.following, 6, -kInfinity, kNoObject);
  row.fill(3, kStill, kStill);
  EXPECT_EQ(row.shown(3), 6.0f);
  EXPECT_EQ(row.causes.newly_visible, 1u);
}

TEST(Missed, neighbours_count_with_their_shown_colour) {
  Row row;
  test::set_point(row.previous, 2, 0.0f);
  test::set_point(row.following, 2, 0.0f);
  row.following.film.data[3 * 2] = 12.0f;
  row.fill(3, kStill, kStill);
  EXPECT_EQ(row.shown(3), 7.0f);  // mean of 2 in the previous frame and 12 in the following frame
}

TEST(Missed, without_neighbours_both_frames_are_averaged) {
  Row row;
  row.following.film.data[3 * 3] = 13.0f;
  row.fill(3, kStill, kStill);
  EXPECT_EQ(row.shown(3), 8.0f);  // mean of 3 in the previous frame and 13 in the following frame
  EXPECT_EQ(row.causes.not_covered, 1u);
  EXPECT_EQ(row.causes.newly_visible, 0u);
}

TEST(Missed, surface_inside_a_frame_was_hidden) {
  Row row;
  test::set_point(row.previous, 2, 0.0f);  // the object moves by 2 pixels, so the point at pixel 7 was at pixel 5
  row.fill(7, {test::shift(2, 0, 0)}, {test::shift(4, 0, 0)});
  EXPECT_EQ(row.causes.newly_visible, 1u);
}

TEST(Missed, surface_outside_both_frames_was_not_covered) {
  Row row;
  // the point at pixel 1 was at -1 in the previous frame, and will be at -3 in the following frame
  test::set_point(row.previous, 2, 0.0f);
  row.fill(1, {test::shift(2, 0, 0)}, {test::shift(4, 0, 0)});
  EXPECT_EQ(row.causes.not_covered, 1u);
  Row left_again;
  test::set_point(left_again.previous, 2, 0.0f);
  left_again.fill(1, {test::shift(2, 0, 0)}, {test::shift(-4, 0, 0)});
  EXPECT_EQ(left_again.causes.newly_visible, 1u);
}

}  // namespace
}  // namespace lippmann
