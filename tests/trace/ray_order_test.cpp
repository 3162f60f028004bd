#include "trace/strip_order.hpp"

#include <gtest/gtest.h>

#include <set>

#include "trace/packet_source.hpp"

namespace lippmann {
namespace {

constexpr RayOrder kOrders[] = {RayOrder::kRows, RayOrder::kColumns, RayOrder::kViewTiles};

std::vector<Optics> optics_of_odd_sizes() {
  std::vector<Optics> all;
  Optics o;
  o.panel = {48, 37, 0.125f};
  o.model = LenticularSheet{};
  all.push_back(o);
  std::get<LenticularSheet>(o.model).lens_pitch_mm = 1.1f;  // not a multiple of the pixel width
  all.push_back(o);
  o.panel = {24, 40, 0.25f};
  o.model = MicrolensArray{};
  all.push_back(o);
  o.panel = {35, 21, 0.2f};
  o.model = SingleView{};
  all.push_back(o);
  o.panel = {17, 27, 0.3f};
  o.model = SlantedPanel{.periods = 4.3, .tilt = 0.9};
  all.push_back(o);
  std::get<SlantedPanel>(o.model).tilt = -0.9;
  all.push_back(o);
  return all;
}

TEST(StripOrder, every_order_and_optics_holds_each_pixel_once) {
  for (const Optics& optics : optics_of_odd_sizes())
    for (const RayOrder order : kOrders) {
      const StripOrder strip = make_strip_order(optics, order);
      std::set<std::pair<int, int>> seen;
      for (const StripPixel p : strip.pixels) {
        EXPECT_LT(p.x, film_size(optics).x);
        EXPECT_LT(p.y, strip.strip_height);
        EXPECT_TRUE(seen.insert({p.x, p.y}).second) << to_string(order) << " repeats " << p.x << ", " << p.y;
      }
      EXPECT_EQ(seen.size(), static_cast<std::size_t>(film_size(optics).x * strip.strip_height)) << to_string(order);
    }
}

TEST(StripOrder, sheet_packets_have_one_view_and_lens) {
  const StripOrder strip = make_strip_order(optics_of_odd_sizes()[0], RayOrder::kViewTiles);
  for (std::size_t i = 0; i < strip.pixels.size(); i += 16)
    for (std::size_t lane = 1; lane < 16; ++lane) EXPECT_EQ(strip.pixels[i + lane].x, strip.pixels[i].x);
  EXPECT_EQ(strip.pixels[16].x, strip.pixels[0].x + 8) << "the next packet covers the next lens of the same view";
}

TEST(StripOrder, view_tiles_of_microlenses_share_one_direction) {
  Optics o;
  o.panel = {64, 64, 0.125f};
  o.model = MicrolensArray{};
  const StripOrder strip = make_strip_order(o, RayOrder::kViewTiles);
  for (std::size_t i = 0; i < strip.pixels.size(); ++i) {
    EXPECT_EQ(strip.pixels[i].x % 8, strip.pixels[i - i % 16].x % 8);
    EXPECT_EQ(strip.pixels[i].y % 8, strip.pixels[i - i % 16].y % 8);
  }
}

TEST(StripOrder, view_tiles_of_a_slanted_panel_follow_its_lenses) {
  // A lens is 10 sub-pixels wide and shifts by 600 x 0.25 / 100 = 1.5 sub-pixels per row. The pixels of a packet follow
  // this slant. Their positions below the lens differ by up to 2/10 of a lens: 1/10 by rounding, and 1/10 because a
  // packet has two columns.
  Optics o;
  o.panel = {200, 100, 0.3f};
  for (const double tilt : {0.25, -0.25}) {
    const SlantedPanel slanted{.periods = 60.0, .tilt = tilt, .center = 0.05, .view_cone = 0.5f};
    o.model = slanted;
    const StripOrder strip = make_strip_order(o, RayOrder::kViewTiles);
    int wide = 0;
    for (std::size_t i = 0; i < strip.pixels.size(); i += 16) {
      double low = 1e9, high = -1e9;
      for (std::size_t lane = i; lane < i + 16; ++lane) {
        const double x = (strip.pixels[lane].x + 0.5) / 600, y = 1.0 - (strip.pixels[lane].y + 0.5) / 100;
        const double phase = (x + y * tilt) * 60.0;
        low = std::min(low, phase), high = std::max(high, phase);
      }
      if (high - low > 0.21) ++wide;
    }
    // A packet that crosses a side of the panel continues at the other side, with different phases. Over 16 rows the
    // lenses shift by 24 sub-pixels, so up to 24 packets are split.
    EXPECT_LE(wide, 24);
  }
}

TEST(PacketSource, fill_covers_panels_of_any_size_once) {
  for (const Optics& optics : optics_of_odd_sizes())
    for (const RayOrder order : kOrders) {
      const PacketSource source(optics, Affine3f{}, order, SubPixel{});
      std::set<std::uint32_t> seen;
      RayPacket rays;
      LaneMask active;
      std::uint32_t pixel[kLanes];
      for (int strip = 0; strip < source.strips(); ++strip)
        for (int p = 0; p < source.packets_per_strip(); ++p) {
          if (source.fill(strip, p, 0, rays, active, pixel) == 0) continue;
          for (int i = 0; i < kLanes; ++i) {
            if (active.lane[i]) {
              EXPECT_TRUE(seen.insert(pixel[i]).second);
            }
          }
        }
      EXPECT_EQ(seen.size(), static_cast<std::size_t>(film_size(optics).x * optics.panel.height));
    }
}

TEST(PacketSource, fill_gives_the_rays_of_the_optics) {
  const Optics optics = optics_of_odd_sizes()[0];
  const PacketSource source(optics, Affine3f{}, RayOrder::kViewTiles, SubPixel{});
  RayPacket rays;
  LaneMask active;
  std::uint32_t pixel[kLanes];
  ASSERT_EQ(source.fill(1, 7, 0, rays, active, pixel), kLanes);
  for (int i = 0; i < kLanes; ++i) {
    const Vec2f center(static_cast<float>(pixel[i] % 48) + 0.5f, static_cast<float>(pixel[i] / 48) + 0.5f);
    const Ray expected = ray_of_pixel(optics, center);
    EXPECT_EQ(Vec3f(rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]), expected.direction);
    EXPECT_EQ(Vec3f(rays.org_x[i], rays.org_y[i], rays.org_z[i]), expected.origin);
  }
}

TEST(SubPixel, samples_of_a_pixel_fill_every_stratum) {
  const SubPixel sub{3, 16};
  std::set<int> columns, rows;
  for (int s = 0; s < 16; ++s) {
    const Vec2f p = sub.position(1234, s);
    ASSERT_GE(std::min(p.x, p.y), 0.0f);
    ASSERT_LT(std::max(p.x, p.y), 1.0f);
    // All samples of a pixel have the same shift. Relative to sample 0, they must be in 16 different sixteenths of the
    // pixel, across and down.
    columns.insert(static_cast<int>(std::floor((p.x - sub.position(1234, 0).x + 1.0f) * 16.0f + 0.5f)) % 16);
    rows.insert(static_cast<int>(std::floor((p.y - sub.position(1234, 0).y + 1.0f) * 16.0f + 0.5f)) % 16);
  }
  EXPECT_EQ(columns.size(), 16u);
  EXPECT_EQ(rows.size(), 16u);
}

TEST(SubPixel, pixels_and_seeds_have_different_positions) {
  EXPECT_NE(SubPixel({0, 4}).position(1, 0), SubPixel({0, 4}).position(2, 0));
  EXPECT_NE(SubPixel({0, 4}).position(1, 0), SubPixel({1, 4}).position(1, 0));
  EXPECT_EQ(SubPixel({0, 1}).position(1, 0), Vec2f(0.5f));
}

}  // namespace
}  // namespace lippmann
