#include "lippmann/optics/optics.hpp"

#include "optics/ray_generator.hpp"

namespace lippmann {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

/// lens pitch (seen in perspective from the viewing distance) or the magnified pixel, whichever is wider.
float lens_footprint_mm(float pitch_mm, float gap_mm, float viewing_distance_mm, float pixel_pitch_mm, float z_mm) {
  return std::max(pitch_mm * std::abs(1.0f - z_mm / viewing_distance_mm), std::abs(z_mm) * pixel_pitch_mm / gap_mm);
}

float lens_zone(float pitch_mm, float gap_mm, float viewing_distance_mm) {
  const float cell_mm = pitch_mm * (1.0f + gap_mm / viewing_distance_mm);
  return 2.0f * std::atan(cell_mm / (2.0f * gap_mm));
}

/// What lies below one lens of a slanted panel, along a row.
struct SlantedLens {
  float pitch_mm;
  float slope_step;  ///< dx/dz from one sub-pixel to the next
};

SlantedLens slanted_lens(const Panel& panel, const SlantedPanel& slanted) {
  const auto sub_pixels = static_cast<float>(panel.width / slanted.periods);
  return {sub_pixels * panel.pixel_pitch_mm, 2.0f * std::tan(0.5f * slanted.view_cone) / sub_pixels};
}

/// Of a camera grid: of as many baselines as there are eyes, of the longer side.
float views_zone(const MultiView& views) {
  if (!(views.baseline_mm > 0.0f)) return views.view_cone;
  const auto eyes = static_cast<float>(std::max(views.columns, views.rows));
  return 2.0f * std::atan(0.5f * eyes * views.baseline_mm / views.distance_mm);
}

/// Where a point in front of the plane moves by one pixel between the two middle views.
float view_budget_mm(const MultiView& views, float pixel_pitch_mm) {
  const int steps = views.columns * views.rows - (views.cone_ends_included ? 1 : 0);
  if (views.columns * views.rows < 2) return kInfinity;
  const float on_cone = 2.0f * views.distance_mm * std::tan(0.5f * views.view_cone / static_cast<float>(steps));
  const float eyes_apart = views.baseline_mm > 0.0f ? views.baseline_mm : on_cone;
  return pixel_pitch_mm * views.distance_mm / (eyes_apart + pixel_pitch_mm);
}

}  // namespace

float resolved_z_front_mm(const Optics& optics) {
  const float chosen = optics.z_front_mm;
  const float diagonal =
      optics.panel.pixel_pitch_mm * std::hypot(static_cast<float>(optics.panel.width), static_cast<float>(optics.panel.height));
  const auto of_lenses = [&](float viewing_distance) {
    if (std::isfinite(chosen)) return chosen;
    return std::isfinite(viewing_distance) ? viewing_distance : 4.0f * diagonal;
  };
  return std::visit(Overloaded{[&](const LenticularSheet& s) { return of_lenses(s.viewing_distance_mm); },
                               [&](const MicrolensArray& a) { return of_lenses(a.viewing_distance_mm); },
                               [&](const MultiView& v) { return std::min(chosen, v.distance_mm); },
                               [&](const SingleView& v) { return std::min(chosen, v.distance_mm); },
                               [&](const SlantedPanel& p) { return std::min(chosen, p.distance_mm); }},
                    optics.model);
}

Ray ray_of_pixel(const Optics& optics, Vec2f pixel) { return RayGenerator(optics).ray(pixel); }

void rays_of_pixels(const Optics& optics, const float* pixel_x, const float* pixel_y, int count, const RayArrays& rays) {
  RayGenerator(optics).rays(pixel_x, pixel_y, count, rays);
}

void pixels_seeing(const Optics& optics, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  if (!std::isfinite(point_mm.x) || !std::isfinite(point_mm.y) || !std::isfinite(point_mm.z)) return;
  if (!(point_mm.z <= resolved_z_front_mm(optics) && point_mm.z >= -optics.z_back_mm)) return;
  std::visit([&](const auto& model) { pixels_seeing(optics.panel, model, point_mm, pixels); }, optics.model);
}

Vec2i whole_pixels_per_lens(const Optics& optics) {
  return std::visit(Overloaded{[&](const LenticularSheet& s) {
                                 const int n = make_lenticular(optics.panel, s, 0.0).axis.whole_pixels;
                                 return n > 0 ? Vec2i(n, 1) : Vec2i(0);
                               },
                               [&](const MicrolensArray& a) {
                                 const auto c = make_microlens(optics.panel, a, 0.0);
                                 const Vec2i n(c.columns.whole_pixels, c.rows.whole_pixels);
                                 return n.x > 0 && n.y > 0 ? n : Vec2i(0);
                               },
                               [](const MultiView&) { return Vec2i(1); }, [](const SingleView&) { return Vec2i(1); },
                               [](const SlantedPanel&) { return Vec2i(0); }},
                    optics.model);
}

Vec2f sample_footprint_mm(const Optics& optics, float z_mm) {
  const float m = optics.panel.pixel_pitch_mm;
  const auto of_lens = [&](const auto& a, float pitch) {
    return lens_footprint_mm(pitch, a.gap_mm / a.parallax, a.viewing_distance_mm, m, z_mm);
  };
  return std::visit(
      Overloaded{[&](const LenticularSheet& s) {
                   const float along = m * std::abs(1.0f - (z_mm + s.gap_mm) / (s.viewing_distance_mm + s.gap_mm));
                   return Vec2f(of_lens(s, s.lens_pitch_mm), along);
                 },
                 [&](const MicrolensArray& a) {
                   const float rows = a.packing == LensPacking::kHexagonal ? std::sqrt(0.75f) : 1.0f;
                   return Vec2f(of_lens(a, a.lens_pitch_mm), of_lens(a, a.lens_pitch_mm * rows));
                 },
                 [&](const MultiView& v) { return Vec2f(1.0f, v.pixel_height) * (m * std::abs(1.0f - z_mm / v.distance_mm)); },
                 [&](const SingleView& v) { return Vec2f(m * std::abs(1.0f - z_mm / v.distance_mm)); },
                 [&](const SlantedPanel& p) {
                   const SlantedLens lens = slanted_lens(optics.panel, p);
                   const float pixel = 3.0f * m * std::abs(1.0f - z_mm / p.distance_mm);
                   return Vec2f(std::max(pixel, std::abs(z_mm) * lens.slope_step * p.parallax), pixel);
                 }},
      optics.model);
}

float viewing_zone(const Optics& optics) {
  return std::visit(
      Overloaded{[](const LenticularSheet& s) { return lens_zone(s.lens_pitch_mm, s.gap_mm, s.viewing_distance_mm); },
                 [](const MicrolensArray& a) { return lens_zone(a.lens_pitch_mm, a.gap_mm, a.viewing_distance_mm); },
                 [](const MultiView& v) { return views_zone(v); }, [](const SingleView&) { return 0.0f; },
                 [](const SlantedPanel& p) { return p.view_cone; }},
      optics.model);
}

float depth_budget_mm(const Optics& optics) {
  const float m = optics.panel.pixel_pitch_mm;
  return std::visit(
      Overloaded{[&](const LenticularSheet& s) { return s.lens_pitch_mm * s.gap_mm / m; },
                 [&](const MicrolensArray& a) { return a.lens_pitch_mm * a.gap_mm / m; },
                 [&](const MultiView& v) { return view_budget_mm(v, m); }, [](const SingleView&) { return kInfinity; },
                 [&](const SlantedPanel& p) {
                   const SlantedLens lens = slanted_lens(optics.panel, p);
                   return lens.pitch_mm / lens.slope_step;
                 }},
      optics.model);
}

Optics with_parallax(Optics optics, float parallax) {
  std::visit(Overloaded{[](SingleView&) {}, [&](auto& model) { model.parallax = parallax; }}, optics.model);
  return optics;
}

Vec2f window_size_mm(const Optics& optics) {
  const Panel& panel = optics.panel;
  Vec2f size = Vec2f(panel.width, panel.height) * panel.pixel_pitch_mm;
  if (const auto* views = std::get_if<MultiView>(&optics.model))
    size = Vec2f(1.0f, views->pixel_height) * Vec2f(panel.width / views->columns, panel.height / views->rows) *
           panel.pixel_pitch_mm;
  if (std::holds_alternative<SlantedPanel>(optics.model)) size.y *= 3.0f;
  return size;
}

}  // namespace lippmann
