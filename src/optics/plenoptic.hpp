// Computes the rays of a plenoptic camera. A ray runs from a point of the sensor straight through the centre of its microlens
// to the main lens, which refracts it.
//
// Symbols:
//   f, N   focal length and f-number of the main lens
//   Z      distance from the main lens to a point; Zf (distance_mm) is the distance to the plane z = 0
//   s      s = f Zf / (Zf - f), distance from the main lens to its image of the plane z = 0
//   e, t   array_shift_mm, and t = s + e, distance from the main lens to the microlens array
//   b      gap from the array to the sensor
//   m, p   pixel pitch and pitch of the microlenses
//   l      position of a microlens
//   A      position on the main lens
// All lengths on the sensor are those of the upright picture, so their signs are opposite to the real positions behind the main
// lens.
//
// 1. The centre of the main lens is imaged by microlens l to l (1 + b/t). Cells are therefore those of a lens array seen from
//    the distance t (optics/lens_axis.hpp), and are p (1 + b/t) apart.
// 2. The ray of a pixel at offset o (in pixels) from the centre of its cell passes through the point A = o m t/b of the main
//    lens. The ray is blocked if |A| > f / 2N. The images below the microlenses touch if b = N p (1 + b/t) t/f.
// 3. The main lens (a thin lens) adds A/f to the slope of the ray. In front of the camera, the line is
//    x(Z) = A - Z (A/f - (A + l)/t).
//
// For e = 0, the line is x(Z) = A (1 - Z/Zf) + l Z/s. Then all pixels below a microlens see the same point of the plane z = 0.
// A point (X, Z) appears in the view through A at l = s (X/Z + A (1/Zf - 1/Z)). Neighbouring views are m t/b apart on the main
// lens. Their disparity is s (1/Zf - 1/Z) m t / (b p) lenses, which is 0 in the plane z = 0.
//
// Microlenses are modelled as pinholes, so the sharpness of their images plays no role. In a plenoptic camera 2.0, microlenses
// of focal length g image the main lens's image of the plane z = 0 sharply if 1/e + 1/b = 1/g.
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
  LensRays lenses;
  float array_mm;            ///< distance from the main lens to the array
  float power;               ///< 1 / focal length, per mm
  float front_from_lens_mm;  ///< z of the plane z_front relative to the main lens, <= 0
  float aperture_radius_mm2;
};

struct SquarePlenopticRays : PlenopticRays<SquareMicrolensRays> {};
struct HexagonalPlenopticRays : PlenopticRays<HexagonalMicrolensRays> {};

/// The point A where a ray meets the main lens, and the slope of the ray on the sensor's side, -(A + l)/t. plenoptic.hpp
/// explains the symbols.
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

/// Returns the distance from the main lens to its image of the plane z = 0.
inline double image_distance_mm(double focal_length_mm, double distance_mm) {
  return focal_length_mm * distance_mm / (distance_mm - focal_length_mm);
}

inline double array_distance_mm(const PlenopticCamera& camera) {
  return image_distance_mm(camera.focal_length_mm, camera.distance_mm) + static_cast<double>(camera.array_shift_mm);
}

// The functions of optics/model.hpp follow.

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
