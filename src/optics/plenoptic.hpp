// Rays of a plenoptic camera: from a point of the sensor straight through the centre of the microlens above it, to the main
// lens, and refracted there.
//
// Symbols: f the focal length of the main lens and N its f-number; Z the distance from it to a point, Zf (distance_mm) to the
// plane z = 0; s = f Zf / (Zf - f) the image distance of that plane; e the shift of the array, so that it stands t = s + e
// behind the main lens; b its gap to the sensor, m the pixel pitch. All lengths on the sensor are those of the upright picture:
// they have the opposite sign of where they lie behind the lens.
//
//   The main lens's image of its own centre below microlens l is at l (1 + b/t): cells are that of a lens array that is seen
//   from the distance t, and lens images p (1 + b/t) apart (optics/lens_axis.hpp).
//   A pixel o beside that image is reached through the point A = o m t/b of the main lens, and blocked if |A| > f / 2N. Lens
//   images touch where b = N p (1 + b/t) t/f.
//   A thin lens adds A/f to the slope of a ray. Outside, the line is x(Z) = A - Z (A/f - (A + l)/t).
//
// For e = 0 that is x(Z) = A (1 - Z/Zf) + l Z/s: all pixels below a microlens see one point of the plane z = 0. A point (X, Z)
// appears in the view through A at l = s (X/Z + A (1/Zf - 1/Z)). So neighbouring views, m t/b apart on the main lens, have a
// disparity of s (1/Zf - 1/Z) m t / (b p) lenses: none in the plane in focus.
//
// Microlenses are pinholes in their centres: their focal length decides how sharp the image below each is, which is not
// modelled. In a plenoptic camera 2.0 the array is where lenses of focal length g image the main lens's image of z = 0 sharply:
// 1/e + 1/b = 1/g.
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/microlens.hpp"
#include "optics/model.hpp"

namespace lippmann {

template <class LensRays>
struct PlenopticRays {
  LensRays lenses;            ///< their lines in the plane of the array
  float array_mm;             ///< t
  float power;                ///< 1/f
  float front_from_lens_mm;   ///< z_front - Zf, <= 0
  float aperture_radius_mm2;  ///< squared
};

struct SquarePlenopticRays : PlenopticRays<SquareMicrolensRays> {};
struct HexagonalPlenopticRays : PlenopticRays<HexagonalMicrolensRays> {};

/// The point where a ray meets the main lens, and its slope on the sensor side, -(A + l)/t.
struct MainLensCrossing {
  Vec2f at, slope;
};

template <class LensRays>
LIPPMANN_INLINE MainLensCrossing at_main_lens(const PlenopticRays<LensRays>& c, float px, float py) {
  const Crossing line = crossing(c.lenses, px, py);
  return {{-(line.x + c.array_mm * line.slope_x), -(line.y + c.array_mm * line.slope_y)}, {line.slope_x, line.slope_y}};
}

template <class LensRays>
LIPPMANN_INLINE Crossing crossing(const PlenopticRays<LensRays>& c, float px, float py) {
  const MainLensCrossing lens = at_main_lens(c, px, py);
  const float slope_x = lens.at.x * c.power + lens.slope.x, slope_y = lens.at.y * c.power + lens.slope.y;
  return {lens.at.x + c.front_from_lens_mm * slope_x, lens.at.y + c.front_from_lens_mm * slope_y, slope_x, slope_y};
}

template <class LensRays>
bool is_blocked(const PlenopticRays<LensRays>& c, float px, float py) {
  const Vec2f at = at_main_lens(c, px, py).at;
  return at.x * at.x + at.y * at.y > c.aperture_radius_mm2;
}

void write_block(const SquarePlenopticRays& constants, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays);
void write_block(const HexagonalPlenopticRays& constants, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays);

/// s: where the main lens makes its image of the plane z = 0.
inline double image_distance_mm(double focal_length_mm, double distance_mm) {
  return focal_length_mm * distance_mm / (distance_mm - focal_length_mm);
}

/// t: from the main lens to the array.
inline double array_distance_mm(const PlenopticCamera& camera) {
  return image_distance_mm(camera.focal_length_mm, camera.distance_mm) + static_cast<double>(camera.array_shift_mm);
}

// ---- What every model answers (optics/model.hpp) ----------------------------------------------------------------------

constexpr std::string_view kind_of(const PlenopticCamera&) { return "plenoptic"; }
constexpr int sub_pixels_of(const PlenopticCamera&) { return 1; }
void check_model(const Panel& panel, const PlenopticCamera& camera);
void write_model(const PlenopticCamera& camera, nlohmann::ordered_json& json);
void read_model(const JsonFields& json, PlenopticCamera& camera);
OpticsFacts facts_of(const Panel& panel, const PlenopticCamera& camera);
inline float front_mm(const Panel&, const PlenopticCamera& camera, float chosen_mm) {
  return std::min(chosen_mm, camera.distance_mm);
}
std::variant<SquarePlenopticRays, HexagonalPlenopticRays> make_rays(const Panel& panel, const PlenopticCamera& camera,
                                                                    float z_front_mm);
Vec2f footprint_mm(const Panel& panel, const PlenopticCamera& camera, float z_mm);
inline Vec2d zone_slope(const Panel&, const PlenopticCamera&, Vec2d) { return Vec2d(0.0); }
inline StepRule step_rule(const Panel&, const PlenopticCamera&, StepsWithin) { return {}; }
const OpticsKindInfo& kind_info(const PlenopticCamera&);

}  // namespace lippmann
