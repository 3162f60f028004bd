#include "shading/light_tree.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace lippmann {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TreeLight lamp(Vec3f middle, float power = 1.0f) {
  TreeLight light;
  light.middle = middle, light.power = power;
  return light;
}

class RandomPlaces {
 public:
  explicit RandomPlaces(unsigned seed) : random_(seed) {}
  float number(float from, float to) { return std::uniform_real_distribution<float>(from, to)(random_); }
  Vec3f place(float half = 5.0f) { return {number(-half, half), number(-half, half), number(-half, half)}; }
  Vec3f direction() {
    while (true)
      if (const Vec3f d = place(1.0f); glm::length(d) <= 1.0f && glm::length(d) > 0.1f) return glm::normalize(d);
  }

 private:
  std::mt19937 random_;
};

enum class Kind { kPoints, kSpots, kFadingSpots, kBalls, kFaces, kClosedFaces };
constexpr Kind kKinds[] = {Kind::kPoints, Kind::kSpots, Kind::kFadingSpots, Kind::kBalls, Kind::kFaces, Kind::kClosedFaces};

std::vector<TreeLight> random_lights(Kind kind, std::size_t count, unsigned seed) {
  RandomPlaces random(seed);
  std::vector<TreeLight> lights;
  for (std::size_t l = 0; l < count; ++l) {
    TreeLight& light = lights.emplace_back(lamp(random.place(), std::pow(10.0f, random.number(-2.0f, 0.0f))));
    if (l % 3 == 0) light.range = random.number(1.0f, 10.0f);
    if (kind == Kind::kSpots) light.axis = random.direction(), light.half_angle = random.number(0.1f, 2.5f);
    if (kind == Kind::kFadingSpots) {
      light.axis = random.direction(), light.half_angle = random.number(0.1f, 2.5f);
      light.inner_angle = light.half_angle * random.number(0.0f, 1.0f);
    }
    if (kind == Kind::kBalls) light.radius = random.number(0.0f, 0.5f), light.variance = squared(light.radius);
    if (kind == Kind::kFaces || kind == Kind::kClosedFaces) light.face = random.direction();
    light.is_closed = kind == Kind::kClosedFaces;
  }
  return lights;
}

/// Returns the irradiance on a surface perpendicular to the light's direction, without shadows.
float light_of(const TreeLight& light, Vec3f at) {
  const Vec3f from = at - light.middle;
  const float distance = glm::length(from);
  if (distance > light.range) return 0.0f;
  const float outer = std::cos(light.half_angle), inner = std::max(std::cos(light.inner_angle), outer + 1e-6f);
  const float ramp = std::clamp((glm::dot(from / distance, light.axis) - outer) / (inner - outer), 0.0f, 1.0f);
  float shining = light.half_angle < kPi ? ramp * ramp : 1.0f;
  if (light.face != Vec3f(0.0f)) shining *= std::abs(glm::dot(from / distance, light.face));
  return light.power * shining / (distance * distance);
}

TEST(LightTree, of_no_lights_draws_none) {
  EXPECT_TRUE(LightTree().empty());
  EXPECT_FALSE(LightTree().choose({}, 0.5f));
  EXPECT_EQ(LightTree().probability(0, {}), 0.0f);
}

TEST(LightTree, of_one_light_always_draws_it) {
  const LightTree tree(std::vector{lamp({1, 2, 3})});
  for (const float u : {0.0f, 0.5f, 0.9999999f}) {
    const auto choice = tree.choose({}, u);
    ASSERT_TRUE(choice);
    EXPECT_EQ(choice->light, 0u);
    EXPECT_EQ(choice->probability, 1.0f);
  }
  EXPECT_EQ(tree.probability(0, {}), 1.0f);
}

// Two lamps straight above at distances 1 and 2 have weights 1 and 1/4, so the first has probability 1 / (1 + 1/4) =
// 0.8. A lamp below the horizon keeps 1/16 of its weight, so one above has 1 / (1 + 1/16) = 16/17.
TEST(LightTree, draws_by_squared_distance_and_horizon) {
  const LightTree far(std::vector{lamp({0, 0, 1}), lamp({0, 0, 2})});
  EXPECT_NEAR(far.probability(0, {Vec3f(0.0f), {0, 0, 1}}), 0.8f, 1e-6f);
  EXPECT_NEAR(far.probability(0, {}), 0.8f, 1e-6f);
  const LightTree below(std::vector{lamp({0, 0, 1}), lamp({0, 0, -1})});
  EXPECT_NEAR(below.probability(0, {Vec3f(0.0f), {0, 0, 1}}), 16.0f / 17.0f, 1e-6f);
  EXPECT_NEAR(below.probability(0, {}), 0.5f, 1e-6f) << "both sides can receive light";
}

// The first face is seen along its normal, the second at 60 degrees, with the weight cos 60 = 1/2. The first has
// probability 2/3.
TEST(LightTree, draws_faces_by_their_cosine) {
  std::vector<TreeLight> lights{lamp({0, 0, 1}), lamp({0, 0, -1})};
  lights[0].face = {0, 0, 1};
  lights[1].face = {0, std::sqrt(0.75f), -0.5f};
  EXPECT_NEAR(LightTree(lights).probability(0, {}), 2.0f / 3.0f, 1e-6f);
}

// The origin is behind the face of lamp 1, whose weight is then 1/16. Lamp 0 has probability 1 / (1 + 1/16) = 16/17.
TEST(LightTree, draws_front_faces_of_closed_bodies) {
  std::vector<TreeLight> lights{lamp({0, 0, 1}), lamp({0, 0, -1})};
  for (TreeLight& light : lights) light.face = {0, 0, -1}, light.is_closed = true;
  const LightTree tree(lights);
  EXPECT_NEAR(tree.probability(0, {}), 16.0f / 17.0f, 1e-3f);
  EXPECT_NEAR(tree.probability(0, {}) + tree.probability(1, {}), 1.0f, 1e-6f);
}

// Half-way between the cosines of outer and inner cone, a lamp fades to (1/2)^2 = 1/4. The second lamp is seen at this
// angle, so the first has probability 1 / (1 + 1/4) = 0.8.
TEST(LightTree, draws_spots_by_their_falloff) {
  std::vector<TreeLight> lights{lamp({0, 0, 1}), lamp({1, 0, 0})};
  for (TreeLight& light : lights) light.half_angle = 0.5f * kPi, light.inner_angle = 0.0f;
  lights[0].axis = {0, 0, -1};
  lights[1].axis = {-0.5f, std::sqrt(0.75f), 0};
  EXPECT_NEAR(LightTree(lights).probability(0, {}), 0.8f, 1e-5f);
}

// Each cluster has sixteen lamps that emit into a half space. With Legendre polynomials up to degree 2, the mean
// emission of lamps with the same axis is 1/2 + 3/4 x, where x is the cosine to the axis. In the first cluster, all
// point towards the receiver: 1.25. In the second, every other lamp points away: 1/2 in all directions.
TEST(LightTree, draws_clusters_of_spots_by_their_mean) {
  std::vector<TreeLight> lights;
  for (int l = 0; l < 32; ++l) {
    const bool left = l < 16;
    lights.push_back(lamp({left ? -1 : 1, 0, 0}));
    lights.back().half_angle = lights.back().inner_angle = 0.5f * kPi;
    lights.back().axis = {left || l % 2 == 1 ? 1 : -1, 0, 0};
  }
  const LightTree tree(lights);
  EXPECT_NEAR(tree.probability(0, {}), 1.25f / 1.75f / 16.0f, 1e-4f);
  EXPECT_NEAR(tree.probability(16, {}), 0.5f / 1.75f / 8.0f, 1e-4f);
  EXPECT_EQ(tree.probability(17, {}), 0.0f);
}

TEST(LightTree, has_less_noise_than_bounding_cones) {
  const std::vector<TreeLight> lights = random_lights(Kind::kFadingSpots, 1000, 1);
  std::vector<TreeLight> hard = lights;
  for (TreeLight& light : hard) light.inner_angle = light.half_angle;
  const LightTree tree(lights), of_hard(hard);
  RandomPlaces random(8);
  double by_tree = 0.0, by_cones = 0.0;  // sums of variances divided by the squared total light
  for (int k = 0; k < 50; ++k) {
    const LightReceiver at{random.place(), Vec3f(0.0f)};
    double all = 0.0, of_tree = 0.0, of_cones = 0.0;
    for (std::uint32_t l = 0; l < lights.size(); ++l) {
      const double light = static_cast<double>(light_of(lights[l], at.position));
      if (!(light > 0.0)) continue;
      all += light;
      of_tree += light * light / static_cast<double>(tree.probability(l, at));
      of_cones += light * light / static_cast<double>(of_hard.probability(l, at));
    }
    by_tree += of_tree / (all * all) - 1.0, by_cones += of_cones / (all * all) - 1.0;
  }
  EXPECT_LT(by_tree, 0.9 * by_cones);
}

TEST(LightTree, probabilities_sum_to_one_everywhere) {
  for (const Kind kind : kKinds)
    for (const std::size_t count : {2u, 16u, 17u, 300u}) {
      const LightTree tree(random_lights(kind, count, 3));
      RandomPlaces random(9);
      for (int k = 0; k < 50; ++k) {
        const LightReceiver at{random.place(8.0f), k % 2 ? random.direction() : Vec3f(0.0f)};
        double sum = 0.0;
        for (std::uint32_t l = 0; l < count; ++l) sum += static_cast<double>(tree.probability(l, at));
        const bool any = tree.choose(at, 0.5f).has_value();
        if (!any) continue;
        // The sum may be below 1. The descent ends without a light if a cluster seems to be in range, but none of its
        // lights is in range.
        EXPECT_LE(sum, 1.0 + 1e-4) << static_cast<int>(kind) << ' ' << count;
        EXPECT_GT(sum, kind == Kind::kFaces || kind == Kind::kClosedFaces ? 0.999 : 0.0)
            << static_cast<int>(kind) << ' ' << count;
      }
    }
}

TEST(LightTree, draws_lights_with_the_stated_probability) {
  constexpr int kDraws = 1 << 16;
  for (const Kind kind : kKinds) {
    const LightTree tree(random_lights(kind, 100, 5));
    RandomPlaces random(2);
    for (int k = 0; k < 8; ++k) {
      const LightReceiver at{random.place(), random.direction()};
      std::vector<int> drawn(100);
      for (int i = 0; i < kDraws; ++i)
        if (const auto choice = tree.choose(at, (static_cast<float>(i) + 0.5f) / kDraws)) {
          EXPECT_NEAR(choice->probability, tree.probability(choice->light, at), 1e-5f * choice->probability);
          ++drawn[choice->light];
        }
      // Evenly spaced numbers choose the lights, and each light has an interval of these numbers. At each end of the
      // interval, the count is off by less than 1.
      for (std::uint32_t l = 0; l < 100; ++l)
        EXPECT_NEAR(drawn[l], tree.probability(l, at) * kDraws, 2.0f) << static_cast<int>(kind) << ' ' << l;
    }
  }
}

TEST(LightTree, estimates_the_total_light) {
  constexpr int kDraws = 1 << 18;
  for (const Kind kind : kKinds) {
    const std::vector<TreeLight> lights = random_lights(kind, 500, 7);
    const LightTree tree(lights);
    RandomPlaces random(4);
    for (int k = 0; k < 4; ++k) {
      const LightReceiver at{random.place(), random.direction()};
      double all = 0.0, drawn = 0.0;
      for (const TreeLight& light : lights) all += static_cast<double>(light_of(light, at.position));
      for (int i = 0; i < kDraws; ++i)
        if (const auto choice = tree.choose(at, (static_cast<float>(i) + 0.5f) / kDraws))
          drawn += static_cast<double>(light_of(lights[choice->light], at.position) / choice->probability) / kDraws;
      EXPECT_NEAR(drawn, all, 2e-3 * all) << static_cast<int>(kind);
    }
  }
}

TEST(LightTree, never_omits_a_contributing_light) {
  for (const Kind kind : kKinds) {
    const std::vector<TreeLight> lights = random_lights(kind, 400, 11);
    const LightTree tree(lights);
    RandomPlaces random(6);
    for (int k = 0; k < 100; ++k) {
      const LightReceiver at{random.place(), random.direction()};
      for (std::uint32_t l = 0; l < lights.size(); ++l)
        if (light_of(lights[l], at.position) > 0.0f) {
          EXPECT_GT(tree.probability(l, at), 0.0f) << static_cast<int>(kind) << ' ' << l;
        }
    }
  }
}

// The tree must have at most half of the second moment of sampling by power alone.
TEST(LightTree, has_less_noise_than_drawing_by_power) {
  const std::vector<TreeLight> lights = random_lights(Kind::kPoints, 1000, 1);
  const LightTree tree(lights);
  double power = 0.0;
  for (const TreeLight& light : lights) power += static_cast<double>(light.power);
  RandomPlaces random(8);
  for (int k = 0; k < 10; ++k) {
    const LightReceiver at{random.place(), Vec3f(0.0f)};
    double by_tree = 0.0, by_power = 0.0;  // second moments of light / probability
    for (std::uint32_t l = 0; l < lights.size(); ++l) {
      const double light = static_cast<double>(light_of(lights[l], at.position));
      if (!(light > 0.0)) continue;
      by_tree += light * light / static_cast<double>(tree.probability(l, at));
      by_power += light * light * power / static_cast<double>(lights[l].power);
    }
    EXPECT_LT(by_tree, 0.5 * by_power) << k;
  }
}

TEST(LightTree, lights_without_power_or_position_are_ignored) {
  std::vector<TreeLight> lights{
      lamp(Vec3f(1.0f), 0.0f), lamp(Vec3f(1.0f), -1.0f), lamp(Vec3f(1.0f), kNan), lamp(Vec3f(1.0f), kInfinity),
      lamp({kNan, 0, 0}),      lamp({kInfinity, 0, 0}),  lamp({1, 0, 0})};
  const LightTree tree(lights);
  for (std::uint32_t l = 0; l < 6; ++l) EXPECT_EQ(tree.probability(l, {}), 0.0f) << l;
  EXPECT_EQ(tree.probability(6, {}), 1.0f);
  for (const float u : {0.0f, 0.3f, 0.999f}) EXPECT_EQ(tree.choose({}, u)->light, 6u);
  lights.pop_back();
  EXPECT_TRUE(LightTree(lights).empty());
}

TEST(LightTree, coincident_lamps_are_drawn_by_power) {
  std::vector<TreeLight> lights;
  for (int l = 0; l < 1000; ++l) lights.push_back(lamp({1, 2, 3}, static_cast<float>(l % 4)));
  const LightTree tree(lights);
  for (std::uint32_t l = 0; l < lights.size(); ++l) EXPECT_NEAR(tree.probability(l, {}), lights[l].power / 1500.0f, 1e-6f);
  const LightReceiver there{{1, 2, 3}, {0, 0, 1}};
  ASSERT_TRUE(tree.choose(there, 0.4f));
  EXPECT_GT(tree.choose(there, 0.4f)->probability, 0.0f);
}

TEST(LightTree, spots_that_face_away_are_not_drawn) {
  std::vector<TreeLight> lights;
  for (int l = 0; l < 200; ++l) {
    lights.push_back(lamp({0.01f * static_cast<float>(l), 0, 1}));
    lights.back().axis = {0, 0, 1}, lights.back().half_angle = radians(80.0f);
  }
  EXPECT_FALSE(LightTree(lights).choose({}, 0.5f));
  lights[7].axis = {0, 0, -1};
  EXPECT_EQ(LightTree(lights).choose({}, 0.5f)->light, 7u);
  EXPECT_NEAR(LightTree(lights).choose({}, 0.5f)->probability, 1.0f, 1e-6f);
}

TEST(LightTree, invalid_points_draw_nothing) {
  const LightTree tree(random_lights(Kind::kSpots, 100, 2));
  EXPECT_FALSE(tree.choose({Vec3f(kNan), {0, 0, 1}}, 0.5f));
  EXPECT_FALSE(tree.choose({Vec3f(kInfinity), {0, 0, 1}}, 0.5f));
  EXPECT_EQ(tree.probability(3, {Vec3f(kNan), {0, 0, 1}}), 0.0f);
}

TEST(LightTree, does_not_depend_on_units) {
  const std::vector<TreeLight> lights = random_lights(Kind::kBalls, 100, 12);
  const LightTree tree(lights);
  for (const float scale : {1e-6f, 1e6f}) {
    std::vector<TreeLight> scaled = lights;
    for (TreeLight& l : scaled)
      l.middle *= scale, l.radius *= scale, l.range *= scale, l.variance *= squared(scale), l.power *= squared(scale);
    const LightTree other(scaled);
    for (std::uint32_t l = 0; l < lights.size(); ++l) {
      const float there = tree.probability(l, {{1, 2, 3}, {0, 0, 1}});
      EXPECT_NEAR(other.probability(l, {scale * Vec3f(1, 2, 3), {0, 0, 1}}), there, 1e-3f * there) << scale;
    }
  }
}

TEST(LightTree, rays_find_all_balls_they_pass) {
  const std::vector<TreeLight> lights = random_lights(Kind::kBalls, 2000, 13);
  const LightTree tree(lights);
  RandomPlaces random(14);
  std::size_t met_at_all = 0, visits = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec3f origin = random.place(), direction = random.direction();
    const float reach = random.number(1.0f, 10.0f);
    std::set<std::uint32_t> met;
    tree.meet(origin, direction, reach, [&](std::uint32_t l) {
      EXPECT_TRUE(met.insert(l).second) << "met twice";
      ++visits;
    });
    for (std::uint32_t l = 0; l < lights.size(); ++l) {
      const Vec3f to = lights[l].middle - origin;
      const float along = std::clamp(glm::dot(to, direction), 0.0f, reach);
      if (glm::length(to - along * direction) < lights[l].radius) {
        EXPECT_TRUE(met.contains(l));
        ++met_at_all;
      }
    }
  }
  EXPECT_GT(met_at_all, 100u);
  EXPECT_LT(visits, 2 * met_at_all) << "other nodes are not visited";
}

}  // namespace
}  // namespace lippmann
