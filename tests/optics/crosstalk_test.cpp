#include "lippmann/optics/crosstalk.hpp"

#include <gmock/gmock.h>

#include "support/error_message.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

// The neighbouring pixel is 1/2 to 3/2 pixels from the centre of a pixel, which is 1 to 3 sigma for sigma = 1/2. Its
// share is the weight of a Gaussian in this interval.
TEST(Crosstalk, neighbour_share_matches_tables) {
  EXPECT_NEAR(neighbour_share(0.5), 0.99865 - 0.84134, 1e-5);
  EXPECT_EQ(neighbour_share(0.0), 0.0);
  const Taps taps = gaussian_taps(7.5, 0.5);
  double sum = 0.0;
  for (const Tap& tap : taps) {
    sum += tap.weight;
    if (tap.index == 6 || tap.index == 8) {
      EXPECT_DOUBLE_EQ(tap.weight, neighbour_share(0.5));
    }
  }
  EXPECT_NEAR(sum, 1.0, 1e-4);  // the filter ends at 4 sigma, so the sum is slightly below 1
}

TEST(Crosstalk, parses_a_share_as_sigma) {
  EXPECT_EQ(read_crosstalk("0.4", "x"), 0.4);
  EXPECT_EQ(read_crosstalk("0%", "x"), 0.0);
  for (const double percent : {0.5, 10.0, 23.0})
    EXPECT_NEAR(neighbour_share(read_crosstalk(std::to_string(percent) + "%", "x")), 0.01 * percent, 1e-9) << percent;
  // If 10 % of a Gaussian lies beyond half a pixel on each side, tables give 0.5 / sigma = 1.2816. The tolerance covers
  // the 1e-4 of the light that falls beyond the neighbours.
  EXPECT_NEAR(read_crosstalk("10%", "x"), 0.5 / 1.2816, 2e-4);
}

TEST(Crosstalk, what_is_no_crosstalk_is_refused) {
  for (const char* text : {"", "ten", "-1", "9", "30%", "10%%", "1 %", "nan", "inf"})
    EXPECT_THAT(test::error_message([&] { read_crosstalk(text, "--crosstalk"); }), HasSubstr("--crosstalk")) << text;
}

TEST(Crosstalk, leaks_only_along_axes_with_power) {
  Optics optics;
  optics.model = LenticularSheet{.slant = radians(60.0f)};
  EXPECT_NEAR(crosstalk_sigmas(optics, 0.3).x, 0.6, 1e-6);
  EXPECT_EQ(crosstalk_sigmas(optics, 0.3).y, 0.0);
  optics.model = MicrolensArray{};
  EXPECT_EQ(crosstalk_sigmas(optics, 0.3), Vec2d(0.3));
  optics.model = MultiView{3, 3};
  EXPECT_EQ(crosstalk_sigmas(optics, 0.3), Vec2d(0.3, 0.0));
  optics.model = MultiView{.columns = 3, .rows = 3, .baseline_mm = 1.0f};
  EXPECT_EQ(crosstalk_sigmas(optics, 0.3), Vec2d(0.3));
  optics.model = SingleView{};
  EXPECT_EQ(crosstalk_sigmas(optics, 0.3), Vec2d(0.0));
}

}  // namespace
}  // namespace lippmann
