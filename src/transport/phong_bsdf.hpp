// Whitted's surface model in path tracing: Lambertian diffuse, a perfect mirror, and transmission, straight or refracted. Only
// point-like lights make highlights. Ambient light is replaced by the traced light.
#pragma once

#include <optional>

#include "transport/bsdf.hpp"

namespace lippmann {

/// Surface parameters at one point, with textures applied. The parts are independent of each other, so together they may
/// reflect more light than arrives.
struct PhongPoint {
  Vec3f diffuse{0.8f};    ///< albedo
  Vec3f highlight{0.0f};  ///< strength times tint
  float highlight_size = 1.0f;
  Vec3f mirror{0.0f};
  float through = 0.0f;  ///< share of transmitted light
  float ior = 1.0f;      ///< 1: straight transmission
};

class PhongBsdf {
 public:
  /// normal: on the viewer's side. view: unit, towards the viewer. entering: the viewer is outside.
  PhongBsdf(const PhongPoint& point, Vec3f normal, Vec3f view, bool entering);

  /// Evaluates the diffuse part only: mirror and transmission are Dirac lobes, and highlight() evaluates the highlight.
  BsdfValue evaluate(Vec3f light) const;

  /// Returns Blinn's highlight of a point-like light, as cosine_f. The light's irradiance is pi times its strength (see
  /// LightTable).
  Vec3f highlight(Vec3f light) const;

  std::optional<BsdfSample> sample(float lobe, Vec2f u) const;

  /// Return the two factors of the diffuse part: its albedo, and cosine_f of a white surface.
  Vec3f diffuse_albedo() const { return point_.diffuse; }
  Vec3f evaluate_diffuse(Vec3f light) const;
  Vec3f normal() const { return normal_; }
  static constexpr bool scatters_through() { return false; }  ///< no transmission other than by Dirac lobes
  static constexpr bool has_coat_apart() { return false; }    ///< see MetalRoughBsdf

 private:
  PhongPoint point_;
  Vec3f normal_, view_;
  bool entering_;
  float diffuse_share_ = 0.0f, mirror_share_ = 0.0f, through_share_ = 0.0f;  ///< probabilities; they add up to 1 or are all 0
};

}  // namespace lippmann
