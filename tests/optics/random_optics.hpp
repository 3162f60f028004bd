// Random but plausible optics of every model, with fixed seeds.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "lippmann/optics/optics.hpp"

namespace lippmann::test {

class OpticsSampler {
 public:
  explicit OpticsSampler(unsigned seed) : engine_(seed) {}

  float uniform(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  bool coin() { return integer(0, 1) == 1; }

  Panel panel() { return {integer(40, 300), integer(30, 200), uniform(0.02f, 0.5f)}; }

  Optics lenticular(bool slanted) {
    Optics o{.panel = panel(), .model = {}};
    LenticularSheet s;
    s.viewing_distance_mm = coin() ? kInfinity : uniform(300.0f, 2000.0f);
    s.gap_mm = uniform(4.0f, 20.0f) * o.panel.pixel_pitch_mm;
    s.lens_pitch_mm = lens_pitch(o.panel, s.gap_mm, s.viewing_distance_mm);
    s.offset_mm = uniform(-3.0f, 3.0f) * s.lens_pitch_mm;
    s.slant = slanted ? uniform(-0.6f, 0.6f) : 0.0f;
    s.eye_height_mm = uniform(-50.0f, 50.0f);
    s.parallax = parallax();
    o.model = s;
    return o;
  }

  Optics microlens(LensPacking packing) {
    Optics o{.panel = panel(), .model = {}};
    MicrolensArray a;
    a.packing = packing;
    a.viewing_distance_mm = coin() ? kInfinity : uniform(300.0f, 2000.0f);
    a.gap_mm = uniform(4.0f, 20.0f) * o.panel.pixel_pitch_mm;
    a.lens_pitch_mm = lens_pitch(o.panel, a.gap_mm, a.viewing_distance_mm);
    a.offset_mm = {uniform(-3.0f, 3.0f) * a.lens_pitch_mm, uniform(-3.0f, 3.0f) * a.lens_pitch_mm};
    a.parallax = parallax();
    o.model = a;
    return o;
  }

  Optics multi_view() {
    Optics o{.panel = panel(), .model = {}};
    MultiView views{integer(1, 6), integer(1, 5), uniform(0.0f, 1.2f), coin(), uniform(200.0f, 1000.0f)};
    if (views.rows % 2 == 0) views.baseline_mm = 0.5f + 50.0f * views.view_cone;  // makes a camera grid
    if (views.view_cone > 0.6f) views.pixel_height = views.view_cone;
    views.parallax = parallax();
    views.eye_height_mm = eye_height();
    o.model = views;
    return o;
  }

  Optics single_view() {
    Optics o{.panel = panel(), .model = {}};
    o.model = SingleView{uniform(200.0f, 1000.0f), {uniform(-1.0f, 1.0f), uniform(-1.0f, 1.0f)}, eye_height()};
    return o;
  }

  /// 2 to 20 sub-pixels per lens, as stripes or at random positions in their pixel.
  Optics slanted_panel() {
    Optics o{.panel = panel(), .model = {}};
    o.panel.width /= 3, o.panel.pixel_pitch_mm *= 3.0f;
    SlantedPanel s;
    s.periods = 3 * o.panel.width / uniform(2.0f, 20.0f);
    s.tilt = uniform(-1.0f, 1.0f), s.center = uniform(-3.0f, 3.0f);
    s.inverted = coin();
    s.view_cone = uniform(0.3f, 1.5f), s.distance_mm = uniform(200.0f, 1000.0f);
    s.sub_pixels = striped_sub_pixels(coin());
    s.parallax = parallax();
    s.eye_height_mm = eye_height();
    if (coin())  // sub-pixels stay in their third of the pixel, because they must not overlap
      for (auto& row : s.sub_pixels)
        for (auto& column : row)
          for (Vec2f& offset : column) offset += Vec2f(uniform(-0.02f, 0.02f), uniform(-0.3f, 0.3f));
    o.model = s;
    return o;
  }

  Optics any(int which) {
    switch (which % 6) {
      case 0:
        return lenticular(false);
      case 1:
        return lenticular(true);
      case 2:
        return microlens(LensPacking::kSquare);
      case 3:
        return microlens(LensPacking::kHexagonal);
      case 4:
        return multi_view();
      default:
        return single_view();
    }
  }

  Optics every(int which) { return which % kKinds == 6 ? slanted_panel() : any(which % kKinds); }
  static constexpr int kKinds = 7;

 private:
  float eye_height() { return coin() ? 0.0f : uniform(-50.0f, 50.0f); }
  float parallax() { return coin() ? 1.0f : uniform(0.2f, 1.0f); }

  /// 2 to 20 pixels per lens, a whole number in half of the cases.
  float lens_pitch(const Panel& p, float gap, float viewing_distance) {
    const float pixels = coin() ? static_cast<float>(integer(2, 20)) : uniform(2.0f, 20.0f);
    return pixels * p.pixel_pitch_mm / (1.0f + gap / viewing_distance);
  }

  std::mt19937 engine_;
};

inline const char* model_name(const Optics& o) {
  constexpr const char* kNames[] = {"lenticular", "microlens", "multi-view", "single view", "slanted panel", "ray table"};
  return kNames[o.model.index()];
}

inline const char* name_of_kind(int kind) {
  constexpr const char* kNames[] = {"lenticular", "slanted",     "square_microlens", "hexagonal_microlens",
                                    "multi_view", "single_view", "slanted_panel"};
  return kNames[kind];
}

inline std::string name_of_param(const testing::TestParamInfo<int>& kind) { return name_of_kind(kind.param); }

/// Scale of the depths in tests, in mm. For lens arrays, this is the gap; for slanted panels, a multiple of the depth
/// at which a lens shows one point over its full width.
inline float gap_of(const Optics& optics) {
  if (const auto* s = std::get_if<LenticularSheet>(&optics.model)) return s->gap_mm / s->parallax;
  if (const auto* a = std::get_if<MicrolensArray>(&optics.model)) return a->gap_mm / a->parallax;
  if (const auto* p = std::get_if<SlantedPanel>(&optics.model))
    return 3.0f * optics.panel.pixel_pitch_mm * static_cast<float>(optics.panel.width / p->periods) /
           (p->view_cone * p->parallax);
  return 8.0f * optics.panel.pixel_pitch_mm;
}

inline Vec3f at_depth(const Ray& ray, float z) { return ray.origin + ray.direction * ((z - ray.origin.z) / ray.direction.z); }

}  // namespace lippmann::test
