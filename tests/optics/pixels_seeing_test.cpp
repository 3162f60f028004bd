#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "optics/ray_generator.hpp"
#include "random_optics.hpp"

namespace lippmann {
namespace {

using test::at_depth;
using test::OpticsSampler;

/// Returns the step in pixels to the pixel whose ray passes through `wanted`, below the same lens or in the same view.
Vec2f pixel_step(const Optics& optics, const Ray& ray, Vec3f wanted) {
  const Vec3f passed = at_depth(ray, wanted.z), at_z0 = at_depth(ray, 0.0f);
  const float m = optics.panel.pixel_pitch_mm / sub_pixels_per_pixel(optics), z = wanted.z;
  const Vec2f miss(wanted.x - passed.x, wanted.y - passed.y);
  if (const auto* s = std::get_if<LenticularSheet>(&optics.model)) {
    const float dy = miss.y / (1.0f - (z + s->gap_mm) / (s->viewing_distance_mm + s->gap_mm));
    const float miss_xi = miss.x * std::cos(s->slant) + miss.y * std::sin(s->slant);
    const float dx = (-miss_xi * s->gap_mm / (s->parallax * z) - dy * std::sin(s->slant)) / std::cos(s->slant);
    return {dx / m, -dy / m};
  }
  if (const auto* a = std::get_if<MicrolensArray>(&optics.model))
    return Vec2f(-miss.x, miss.y) * (a->gap_mm / (a->parallax * z * m));
  if (const auto* p = std::get_if<SlantedPanel>(&optics.model)) {
    // A step `dy` along the column corrects y, but also moves the eye. The step `dx` along the row corrects x and this
    // movement.
    const float shrink = 1.0f - z / p->distance_mm, pitch = film_size(optics).x / static_cast<float>(p->periods) * m;
    // x(z) = x(0) (1 - z / D) + eye z / D, with the viewing distance D
    const float eye = (passed.x - at_z0.x * shrink) * p->distance_mm / z;
    const float reach = p->parallax * p->distance_mm;
    // derivative of the eye's position by the view v
    const float turn = p->view_cone * reach * (1.0f + std::pow(eye / reach, 2.0f));
    const float eye_per_lens = (p->inverted ? -1.0f : 1.0f) * turn * z / p->distance_mm;
    const float dy = miss.y / shrink;
    const float lenses_per_mm_up = static_cast<float>(p->periods * p->tilt) / (3.0f * m * optics.panel.height);
    const float dx = (miss.x - dy * lenses_per_mm_up * eye_per_lens) / (shrink + eye_per_lens / pitch);
    return {dx / m, -dy / (3.0f * m)};
  }
  const auto* views = std::get_if<MultiView>(&optics.model);
  const float distance = views ? views->distance_mm : std::get<SingleView>(optics.model).distance_mm;
  return Vec2f(miss.x, -miss.y / (views ? views->pixel_height : 1.0f)) * (distance / (distance - z) / m);
}

bool on_panel(const Optics& optics, Vec2f p) {
  const auto* views = std::get_if<MultiView>(&optics.model);
  const float right = views ? optics.panel.width / views->columns * views->columns : film_size(optics).x;
  const float top = views ? optics.panel.height % views->rows : 0;
  return p.x >= 0 && p.x < right && p.y >= top && p.y < optics.panel.height;
}

/// Returns all points of the panel whose rays pass through `point`. Starts at 9 points per pixel, because the panel's
/// edge may cut the area below a lens so that it contains no pixel centre.
std::vector<Vec2f> search(const Optics& optics, const RayGenerator& generator, Vec3f point) {
  std::vector<Vec2f> found;
  for (int j = 0; j < 3 * optics.panel.height; ++j)
    for (int i = 0; i < 3 * film_size(optics).x; ++i) {
      const Vec2f start((i + 0.5f) / 3.0f, (j + 0.5f) / 3.0f);
      const Vec2f step = pixel_step(optics, generator.ray(start), point);
      Vec2f there = start + step;
      if (std::abs(step.x) > 1.0f || std::abs(step.y) > 1.0f || !on_panel(optics, there)) continue;
      Vec2f left = pixel_step(optics, generator.ray(there), point);
      // On a slanted panel, the ray does not depend linearly on the pixel, so a second step corrects the first.
      if (glm::length(left) < 0.2f && on_panel(optics, there + left))
        there += left, left = pixel_step(optics, generator.ray(there), point);
      if (glm::length(left) > 0.02f) continue;  // the point lies below another lens or in another view
      const auto same = [&](Vec2f p) { return glm::distance(p, there) < 0.05f; };
      if (std::none_of(found.begin(), found.end(), same)) found.push_back(there);
    }
  return found;
}

bool contains(const std::vector<Vec2f>& pixels, Vec2f p) {
  return std::any_of(pixels.begin(), pixels.end(), [p](Vec2f q) { return glm::distance(p, q) < 0.03f; });
}

/// Distance in pixels from the edge of a lens's pixels, a tile or the panel. Points within this distance are not
/// compared, because rounding decides on which side of the edge they lie.
float edge_px(const Optics& optics) { return std::holds_alternative<SlantedPanel>(optics.model) ? 0.05f : 0.02f; }

bool near_an_edge(const Optics& optics, const RayGenerator& generator, Vec2f p, Vec3f point) {
  const float edge = edge_px(optics);
  for (const Vec2f side : {Vec2f(edge, 0), Vec2f(-edge, 0), Vec2f(0, edge), Vec2f(0, -edge)}) {
    const Vec2f q = p + side;
    if (!on_panel(optics, q)) return true;
    if (glm::length(pixel_step(optics, generator.ray(q), point)) > 2 * edge) return true;
  }
  return false;
}

Vec3f random_point(OpticsSampler& random, const Optics& optics) {
  const float m = optics.panel.pixel_pitch_mm;
  const float nearest = std::holds_alternative<SlantedPanel>(optics.model) ? 0.8f : 0.3f;
  const float depth = std::min(random.uniform(nearest, 12.0f) * test::gap_of(optics), 140.0f);
  const float z = random.coin() ? depth : -depth;
  const Vec2f window = m * Vec2f(optics.panel.width, optics.panel.height);
  return {random.uniform(-0.5f, 0.5f) * window.x, random.uniform(-0.5f, 0.5f) * window.y, z};
}

class PixelsSeeing : public testing::TestWithParam<int> {};

TEST_P(PixelsSeeing, random_points_none_missing_and_none_extra) {
  OpticsSampler random(7000 + GetParam());
  std::size_t compared = 0;
  for (int trial = 0; trial < 12; ++trial) {
    Optics optics = random.every(GetParam());
    optics.panel.width = 3 * random.integer(10, 30) / sub_pixels_per_pixel(optics),
    optics.panel.height = random.integer(30, 60);
    optics.z_front_mm = 150.0f;
    const RayGenerator generator(optics);
    for (int sample = 0; sample < 5; ++sample) {
      const Vec3f point = random_point(random, optics);
      std::vector<Vec2f> seeing;
      pixels_seeing(optics, point, seeing);
      const std::vector<Vec2f> expected = search(optics, generator, point);
      const auto where = [&](Vec2f p) {
        return testing::Message() << test::model_name(optics) << " pixel " << p.x << " " << p.y << ", z " << point.z << ": "
                                  << seeing.size() << " given, " << expected.size() << " found";
      };
      for (const Vec2f& p : expected) {
        if (near_an_edge(optics, generator, p, point)) continue;
        EXPECT_TRUE(contains(seeing, p)) << "missing: " << where(p);
      }
      for (const Vec2f& p : seeing) {
        if (near_an_edge(optics, generator, p, point)) continue;
        EXPECT_LT(glm::length(pixel_step(optics, generator.ray(p), point)), 0.03f) << "extra: " << where(p);
        EXPECT_EQ(std::count_if(seeing.begin(), seeing.end(), [&](Vec2f q) { return glm::distance(p, q) < 0.03f; }), 1)
            << "twice: " << where(p);
      }
      compared += expected.size();
    }
  }
  EXPECT_GT(compared, 20u);
}

INSTANTIATE_TEST_SUITE_P(Models, PixelsSeeing, testing::Range(0, OpticsSampler::kKinds), test::name_of_param);

std::vector<Vec2f> search_in_lens_plane(const Optics& optics, Vec3f point) {
  const RayGenerator generator(optics);
  const auto* sheet = std::get_if<LenticularSheet>(&optics.model);
  const auto distance = [&](Vec2f pixel) {
    const Vec3f lens = at_depth(generator.ray(pixel), 0.0f) - point;
    return sheet ? std::abs(lens.x * std::cos(sheet->slant) + lens.y * std::sin(sheet->slant)) : std::hypot(lens.x, lens.y);
  };
  float nearest = kInfinity;
  std::vector<std::pair<float, Vec2f>> candidates;
  for (int j = 0; j < optics.panel.height; ++j)
    for (int i = 0; i < film_size(optics).x; ++i) {
      const Vec2f centre(i + 0.5f, j + 0.5f);
      if (sheet) {
        const float row_y = at_depth(generator.ray(centre), 0.0f).y;
        const float row_height = std::abs(at_depth(generator.ray(centre + Vec2f(0, 0.5f)), 0.0f).y - row_y);
        if (std::abs(row_y - point.y) > row_height) continue;
      }
      candidates.emplace_back(distance(centre), centre);
      nearest = std::min(nearest, candidates.back().first);
    }
  std::vector<Vec2f> found;
  for (const auto& [d, centre] : candidates)
    if (d < nearest + 1e-3f * optics.panel.pixel_pitch_mm) found.push_back(centre);
  return found;
}

class LensPlane : public testing::TestWithParam<int> {};

TEST_P(LensPlane, all_pixels_of_the_lens_see_it) {
  OpticsSampler random(8000 + GetParam());
  for (int trial = 0; trial < 20; ++trial) {
    Optics optics = random.every(GetParam());
    optics.panel.width = random.integer(50, 90), optics.panel.height = random.integer(50, 70);
    optics.z_front_mm = 30.0f;
    const Panel& panel = optics.panel;
    const Vec3f point(random.uniform(-0.2f, 0.2f) * panel.width * panel.pixel_pitch_mm,
                      random.uniform(-0.2f, 0.2f) * panel.height * panel.pixel_pitch_mm, 0.0f);
    std::vector<Vec2f> seeing;
    pixels_seeing(optics, point, seeing);
    EXPECT_EQ(seeing, search_in_lens_plane(optics, point)) << test::model_name(optics) << " trial " << trial;
    EXPECT_FALSE(seeing.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Models, LensPlane, testing::Range(0, 4), test::name_of_param);

TEST(PixelsSeeingOrder, lenses_come_in_ascending_order) {
  Optics optics{.panel = {96, 96, 0.125f}, .model = MicrolensArray{}};
  std::vector<Vec2f> seeing;
  pixels_seeing(optics, {0.1f, 0.1f, 6.0f}, seeing);
  const Vec2i n = whole_pixels_per_lens(optics);
  ASSERT_EQ(n, Vec2i(8, 8));
  std::vector<int> lenses;
  for (const Vec2f& p : seeing) lenses.push_back(static_cast<int>(p.y) / n.y * 12 + static_cast<int>(p.x) / n.x);
  // With the depth Z and the gap g, |Z| / g = 6 mm / 2 mm = 3 lenses in each direction show the point.
  EXPECT_EQ(lenses.size(), 9u);
  EXPECT_TRUE(std::is_sorted(lenses.begin(), lenses.end()));
}

TEST(PixelsSeeingLimits, distant_or_infinite_points_are_unseen) {
  const Optics arrays[] = {{.panel = {}, .model = LenticularSheet{}},
                           {.panel = {}, .model = MicrolensArray{}},
                           {.panel = {}, .model = MicrolensArray{.packing = LensPacking::kHexagonal}},
                           {.panel = {}, .model = MultiView{}},
                           {.panel = {}, .model = SingleView{}},
                           {.panel = {171, 512, 0.12f}, .model = SlantedPanel{.periods = 40.0}}};
  for (const Optics& optics : arrays)
    for (const float far : {1e30f, -kInfinity, std::nanf("")})
      for (const Vec3f point :
           {Vec3f(far, 0, 0), Vec3f(far, 0, 5), Vec3f(0, far, 0), Vec3f(0, far, -5), Vec3f(0, 1, std::abs(far))}) {
        std::vector<Vec2f> seeing;
        pixels_seeing(optics, point, seeing);
        EXPECT_TRUE(seeing.empty()) << test::model_name(optics) << " " << point.x << " " << point.y << " " << point.z;
      }
}

TEST(PixelsSeeingOrder, results_are_appended) {
  const Optics optics{.panel = {64, 64, 1.0f}, .model = SingleView{}};
  std::vector<Vec2f> seeing{{-1.0f, -2.0f}};
  pixels_seeing(optics, {0.0f, 0.0f, 0.0f}, seeing);
  EXPECT_EQ(seeing, (std::vector<Vec2f>{{-1.0f, -2.0f}, {32.0f, 32.0f}}));
}

}  // namespace
}  // namespace lippmann
