#include "job/test_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "optics/ray_generator.hpp"

namespace lippmann {
namespace {

constexpr float kLine = 0.006f;  ///< half the width of a line, relative to half the height of the display
constexpr float kGrid = 0.25f;   ///< distance between grid lines, relative to half the height of the display

struct Band {
  float end;  ///< right end of the band in the viewing zone, which ranges from 0 (left) to 1
  Vec3f color;
  int arrow;  ///< -1: arrow to the left, 1: to the right, 0: no arrow
};

constexpr Band kBands[] = {{0.2f, {0.80f, 0.04f, 0.02f}, -1},
                           {0.4f, {0.80f, 0.30f, 0.02f}, -1},
                           {0.6f, {0.35f, 0.35f, 0.35f}, 0},
                           {0.8f, {0.02f, 0.45f, 0.55f}, 1},
                           {2.0f, {0.02f, 0.06f, 0.80f}, 1}};

bool near_line(float distance) { return std::abs(distance) < kLine; }

/// The arrow is a triangle with its tip at x = -0.5 or x = 0.5.
bool in_arrow(Vec2f place, int arrow) {
  const float back = 0.5f - static_cast<float>(arrow) * place.x;  // distance from the tip towards the arrow's base
  return arrow != 0 && back > 0.0f && back < 0.6f && std::abs(place.y) < 0.7f * back;
}

bool on_grid(Vec2f place) {
  const auto off = [](float x) { return x - kGrid * std::round(x / kGrid); };
  return near_line(off(place.x)) || near_line(off(place.y));
}

/// Returns where a ray arrives in the viewing zone, from 0 (left) to 1 (right); 0.5 for a single view.
float place_in_zone(const Ray& ray, Vec3f at_plane, float distance_mm, float zone) {
  if (!(zone > 0.0f)) return 0.5f;
  const float slope = ray.direction.x / ray.direction.z + (std::isinf(distance_mm) ? 0.0f : at_plane.x / distance_mm);
  return std::atan(slope) / zone + 0.5f;
}

class PatternFrames final : public FrameMaker {
 public:
  PatternFrames(const Stage& stage, const ThreadPool& pool) : stage_(stage), pool_(pool) {}

  RenderedFrame make(int frame) override {
    const FrameClock clock(pool_);
    RenderedFrame rendered;
    rendered.report.frame = frame;
    rendered.pictures.film = test_pattern_film(stage_.placed.optics, pool_);
    clock.add_to(rendered.report);
    return rendered;
  }

 private:
  const Stage& stage_;
  const ThreadPool& pool_;
};

}  // namespace

Scene test_pattern_scene() {
  Scene scene;
  scene.name = kTestPattern;
  scene.display = DisplayPlacement{-1, 1.0f, 4.0f};
  return scene;
}

Vec3f test_pattern(Vec2f place, float aspect, float zone) {
  const Vec2f to_edge = Vec2f(aspect, 1.0f) - glm::abs(place);
  if (std::min(to_edge.x, to_edge.y) < 4.0f * kLine || near_line(glm::length(place) - 0.8f * std::min(1.0f, aspect)))
    return Vec3f(1.0f);
  const Band& band = *std::find_if(std::begin(kBands), std::end(kBands) - 1, [&](const Band& b) { return zone < b.end; });
  if (in_arrow(place, band.arrow)) return Vec3f(0.9f);
  return on_grid(place) ? 0.3f * band.color : band.color;
}

Image test_pattern_film(const Optics& optics, const ThreadPool& pool) {
  Optics parallel = optics;
  // Rays start only 1 mm in front of the display plane, because the rounding errors of a crossing grow with the distance.
  parallel.z_front_mm = 1.0f;
  const RayGenerator generator(parallel);
  const Vec2f half = 0.5f * window_size_mm(optics);
  const float distance = viewing_distance_mm(optics), zone = viewing_zone(optics);
  const Vec2i size = film_size(optics);
  Image film(size.x, size.y, 3);
  pool.for_each(static_cast<std::size_t>(film.height), [&](std::size_t row) {
    for (int i = 0; i < film.width; ++i) {
      const Ray ray = generator.ray({static_cast<float>(i) + 0.5f, static_cast<float>(row) + 0.5f});
      const Vec3f at_plane = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
      const Vec3f color =
          test_pattern(Vec2f(at_plane.x, at_plane.y) / half.y, half.x / half.y, place_in_zone(ray, at_plane, distance, zone));
      std::copy_n(&color.x, 3, film.pixel(i, static_cast<int>(row)));
    }
  });
  return film;
}

std::unique_ptr<FrameMaker> make_pattern_frames(const Stage& stage, const ThreadPool& pool) {
  return std::make_unique<PatternFrames>(stage, pool);
}

}  // namespace lippmann
