// Whitted's surface among path-traced light: Lambert's diffuse part, a perfect mirror, and light from behind, straight or
// refracted. Its highlight answers to point-like lights alone, and its ambient light gives way to the light that is traced.
#pragma once

#include <optional>

#include "transport/bsdf.hpp"

namespace lippmann {

/// At one point, textures looked up. The parts are as the scene's author chose them: together they may send more than arrives.
struct PhongPoint {
  Vec3f diffuse{0.8f};    ///< albedo
  Vec3f highlight{0.0f};  ///< strength x tint
  float highlight_size = 1.0f;
  Vec3f mirror{0.0f};
  float through = 0.0f;  ///< share of the light behind
  float ior = 1.0f;      ///< 1: straight through
};

class PhongBsdf {
 public:
  /// normal: on the viewer's side; view: unit, towards the viewer; entering: the viewer is outside.
  PhongBsdf(const PhongPoint& point, Vec3f normal, Vec3f view, bool entering);

  /// Knows the diffuse part alone: the others are Dirac lobes, or highlight().
  BsdfValue evaluate(Vec3f light) const;

  /// Blinn's highlight of a point-like light, as cosine_f: pi times the light's strength is its irradiance (see LightTable).
  Vec3f highlight(Vec3f light) const;

  std::optional<BsdfSample> sample(float lobe, Vec2f u) const;

  /// The diffuse part alone is their product: a colour, and cosine_f of a white surface.
  Vec3f diffuse_albedo() const { return point_.diffuse; }
  Vec3f evaluate_diffuse(Vec3f light) const;
  Vec3f normal() const { return normal_; }
  static constexpr bool scatters_through() { return false; }  ///< light from behind, other than by Dirac's lobes
  static constexpr bool has_coat_apart() { return false; }    ///< as MetalRoughBsdf's

 private:
  PhongPoint point_;
  Vec3f normal_, view_;
  bool entering_;
  float diffuse_share_ = 0.0f, mirror_share_ = 0.0f, through_share_ = 0.0f;  ///< probabilities; add up to 1, or are all 0
};

}  // namespace lippmann
