// Whitted's surface model in path tracing: a Lambertian diffuse part, a perfect mirror, and straight or refracted transmission.
// Highlights appear only under point-like lights.
#pragma once

#include <optional>

#include "transport/bsdf.hpp"

namespace lippmann {

/// Surface parameters at one point, with textures applied. The diffuse, mirrored and transmitted fractions may add up to more
/// than 1, so the surface may reflect more light than arrives.
struct PhongPoint {
  Vec3f diffuse{0.8f};
  Vec3f highlight{0.0f};
  float highlight_size = 1.0f;
  Vec3f mirror{0.0f};
  float through = 0.0f;
  float ior = 1.0f;  ///< index of refraction; 1: straight transmission
};

class PhongBsdf {
 public:
  PhongBsdf(const PhongPoint& point, Vec3f normal, Vec3f view, bool entering);

  /// Evaluates only the diffuse part. Mirror and transmission are Dirac lobes.
  BsdfValue evaluate(Vec3f light) const;

  /// Returns Blinn's highlight under a point-like light, times the cosine. light_table.hpp explains its unit.
  Vec3f highlight(Vec3f light) const;

  std::optional<BsdfSample> sample(float lobe, Vec2f u) const;

  Vec3f diffuse_albedo() const { return point_.diffuse; }
  Vec3f evaluate_diffuse(Vec3f light) const;
  Vec3f normal() const { return normal_; }
  static constexpr bool scatters_through() { return false; }
  static constexpr bool has_coat_apart() { return false; }

 private:
  PhongPoint point_;
  Vec3f normal_, view_;
  bool entering_;
  /// Probabilities with which sample() chooses a part; they add up to 1 or are all 0.
  float diffuse_share_ = 0.0f, mirror_share_ = 0.0f, through_share_ = 0.0f;
};

}  // namespace lippmann
