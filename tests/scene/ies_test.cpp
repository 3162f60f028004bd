#include "scene/ies.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/core/error.hpp"
#include "scene/photometric_web.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

/// Returns the text of an IES file. `counts` are the numbers of vertical and horizontal angles; `rest` is the text
/// after the ballast line.
std::string ies(int type, const std::string& counts, const std::string& rest, const std::string& multiplier = "1") {
  return fmt::format("IESNA:LM-63-2002\n[TEST] 1\nTILT=NONE\n1 1000 {} {} {} 2 0 0 0\n1 1 50\n{}\n", multiplier, counts, type,
                     rest);
}

float candelas(const IesProfile& profile, Vec3f direction) {
  return profile.mean_candela * intensity(profile.web, glm::normalize(direction));
}

Vec3f type_c(float vertical, float horizontal) {
  const float v = radians(vertical), h = radians(horizontal);
  return {std::sin(v) * std::cos(h), std::sin(v) * std::sin(h), -std::cos(v)};
}

TEST(Ies, one_horizontal_angle_is_alike_all_around) {
  const IesProfile p = parse_ies("a.ies", ies(1, "3 1", "0 45 90\n0\n100 60 20"));
  EXPECT_NEAR(candelas(p, {0, 0, -1}), 100.0f, 0.01f);
  for (const float around : {0.0f, 70.0f, 200.0f, 359.0f}) {
    EXPECT_NEAR(candelas(p, type_c(45, around)), 60.0f, 0.05f) << around;
    EXPECT_NEAR(candelas(p, type_c(67.5f, around)), 40.0f, 0.05f) << around;
  }
  EXPECT_EQ(candelas(p, type_c(91, 10)), 0.0f) << "above what was measured";
}

// A uniform intensity of I candela has a flux of 4 pi I lumens over the sphere, and 2 pi I over a hemisphere. The mean
// intensity is flux / (4 pi): I or I / 2.
TEST(Ies, the_mean_is_that_of_the_flux) {
  EXPECT_NEAR(parse_ies("a.ies", ies(1, "2 1", "0 180\n0\n50 50")).mean_candela, 50.0f, 1e-3f);
  EXPECT_NEAR(parse_ies("a.ies", ies(1, "2 1", "0 90\n0\n50 50")).mean_candela, 25.0f, 1e-3f);
  EXPECT_NEAR(parse_ies("a.ies", ies(1, "2 2", "0 180\n0 180\n50 50 50 50")).mean_candela, 50.0f, 1e-3f);
  EXPECT_NEAR(parse_ies("a.ies", ies(2, "2 2", "-90 90\n-90 90\n50 50 50 50")).mean_candela, 25.0f, 1e-3f);
  EXPECT_NEAR(parse_ies("a.ies", ies(3, "2 2", "-90 90\n-90 90\n50 50 50 50")).mean_candela, 25.0f, 1e-3f);
}

// The intensity I cos(theta) over a hemisphere has a flux of pi I, so the mean is I / 4 = 800 / 4. The cosine is
// interpolated linearly in steps of a degree.
TEST(Ies, lambertian_mean_is_a_quarter_of_peak) {
  std::string angles, values;
  for (int v = 0; v <= 90; ++v) angles += fmt::format("{} ", v), values += fmt::format("{} ", 800.0 * std::cos(v * M_PI / 180));
  const IesProfile p = parse_ies("a.ies", ies(1, "91 1", angles + "\n0\n" + values));
  EXPECT_NEAR(p.mean_candela, 200.0f, 0.02f);
  EXPECT_NEAR(mean_intensity(p.web), 1.0, 1e-6);
}

TEST(Ies, halves_and_quarters_are_made_whole) {
  const IesProfile quarter = parse_ies("a.ies", ies(1, "2 3", "0 180\n0 45 90\n10 10 20 20 30 30"));
  const IesProfile half = parse_ies("a.ies", ies(1, "2 3", "0 180\n0 90 180\n10 10 20 20 30 30"));
  const IesProfile other_half = parse_ies("a.ies", ies(1, "2 3", "0 180\n90 180 270\n10 10 20 20 30 30"));
  const auto around = [](const IesProfile& p, float h) { return candelas(p, type_c(90, h)); };
  for (const float h : {45.0f, 135.0f, 225.0f, 315.0f}) EXPECT_NEAR(around(quarter, h), 20.0f, 0.01f) << h;
  for (const float h : {90.0f, 270.0f}) EXPECT_NEAR(around(quarter, h), 30.0f, 0.01f) << h;
  EXPECT_NEAR(around(half, 270), 20.0f, 0.01f);
  EXPECT_NEAR(around(half, 225), 25.0f, 0.01f);
  EXPECT_NEAR(around(other_half, 0), 20.0f, 0.01f);
  EXPECT_NEAR(around(other_half, 135), 15.0f, 0.01f);
  EXPECT_NEAR(around(other_half, 45), 15.0f, 0.01f);
  EXPECT_NEAR(around(other_half, 315), 25.0f, 0.01f);
}

TEST(Ies, a_circle_that_ends_early_is_closed) {
  const IesProfile p = parse_ies("a.ies", ies(1, "2 4", "0 180\n0 90 180 270\n10 10 20 20 30 30 40 40"));
  EXPECT_NEAR(candelas(p, type_c(90, 315)), 25.0f, 0.01f);
}

// Horizontal angles grow towards +x, vertical angles towards +y. The polar axis is x for type B, and y for type A.
TEST(Ies, types_a_b_point_along_minus_z) {
  const std::string rest = "-90 0 90\n-90 0 90\n0 1 2  3 40 5  6 7 8";
  for (const int type : {2, 3}) {
    const IesProfile p = parse_ies("a.ies", ies(type, "3 3", rest));
    EXPECT_NEAR(candelas(p, {0, 0, -1}), 40.0f, 0.01f) << type;
    EXPECT_EQ(candelas(p, {0, 0, 1}), 0.0f) << type;
    EXPECT_NEAR(candelas(p, {0.3f, 0, -0.9f}), 40.0f + (7.0f - 40.0f) * std::atan2(0.3f, 0.9f) / (0.5f * kPi), 0.05f) << type;
    EXPECT_NEAR(candelas(p, {0, 0.3f, -0.9f}), 40.0f + (5.0f - 40.0f) * std::atan2(0.3f, 0.9f) / (0.5f * kPi), 0.05f) << type;
  }
  const Vec3f corner(std::sqrt(0.5f), 0.5f, -0.5f);  // type B: horizontal and vertical angle of 45 degrees
  const IesProfile b = parse_ies("a.ies", ies(2, "3 3", rest));
  EXPECT_NEAR(candelas(b, corner), 0.25f * (40 + 5 + 7 + 8), 0.05f);
}

TEST(Ies, sides_stand_for_both) {
  const IesProfile p = parse_ies("a.ies", ies(2, "2 2", "0 90\n0 90\n40 10 20 5"));
  for (const float x : {-0.5f, 0.5f})
    for (const float y : {-0.5f, 0.5f}) EXPECT_NEAR(candelas(p, {x, y, -0.7f}), candelas(p, {0.5f, 0.5f, -0.7f}), 1e-3f);
}

TEST(Ies, multipliers_apply_and_tilt_does_not) {
  EXPECT_NEAR(parse_ies("a.ies", ies(1, "2 1", "0 180\n0\n50 50", "0.5")).mean_candela, 25.0f, 1e-3f);
  const std::string tilted =
      "TILT=INCLUDE\r\n1\r\n2\r\n0 90\r\n1 0.8\r\n1 1000 1 2 1 1 2 0 0 0 0.5 1 50\r\n0, 180\r\n0\r\n50,50\r\n";
  EXPECT_NEAR(parse_ies("a.ies", tilted).mean_candela, 25.0f, 1e-3f);
}

TEST(Ies, dark_lamp_has_a_zero_web) {
  const IesProfile p = parse_ies("a.ies", ies(1, "2 1", "0 180\n0\n0 0"));
  EXPECT_EQ(p.mean_candela, 0.0f);
  EXPECT_EQ(p.web.intensity, std::vector<float>(2, 0.0f));
}

std::string problem(const std::string& text) {
  return error_message([&] { parse_ies("a.ies", text); });
}

TEST(Ies, invalid_files_are_rejected_with_line) {
  EXPECT_THAT(problem("IESNA:LM-63-2002\n"), HasSubstr("a.ies: is text that begins 'IESNA:LM-63-2002' without a TILT line"));
  EXPECT_THAT(problem("TILT=NONE\n1 1000 1 2"), HasSubstr("a.ies:2"));
  EXPECT_THAT(problem(ies(4, "2 1", "0 180\n0\n50 50")), HasSubstr("a.ies:4"));
  EXPECT_THAT(problem(ies(1, "1 1", "0\n0\n50")), HasSubstr("the number of vertical angles"));
  EXPECT_THAT(problem(ies(1, "2 1", "0 180\n0\n50 x")), HasSubstr("a.ies:8: expected a number for a candela value, found 'x'"));
  EXPECT_THAT(problem(ies(1, "2 1", "0 180\n0\n50 -1")), HasSubstr("a candela value is -1"));
  EXPECT_THAT(problem(ies(1, "2 1", "0 180\n0\n50 nan")), HasSubstr("a.ies:8"));
  EXPECT_THAT(problem(ies(1, "2 1", "90 0\n0\n50 50")), HasSubstr("a vertical angle is 0 after 90"));
  EXPECT_THAT(problem(ies(1, "99999 99999", "0 180\n")), HasSubstr("a.ies"));
}

TEST(Ies, angles_that_cover_no_sphere_are_refused) {
  EXPECT_THAT(problem(ies(1, "2 2", "0 180\n0 120\n1 1 1 1")), HasSubstr("the horizontal angles go from 0 to 120 degrees"));
  EXPECT_THAT(problem(ies(1, "2 1", "-90 90\n0\n1 1")), HasSubstr("the vertical angles go from -90 to 90 degrees"));
  EXPECT_THAT(problem(ies(2, "2 2", "0 45\n0 90\n1 1 1 1")), HasSubstr("the vertical angles go from 0 to 45 degrees"));
}

}  // namespace
}  // namespace lippmann
