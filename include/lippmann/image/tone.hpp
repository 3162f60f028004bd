// Maps scene light to display light: multiplies by an exposure and applies a curve to highlights brighter than white.
//
// Based on: Khronos Group, "Khronos PBR Neutral Tone Mapper", 2024 (specification); AgX by T. Sobotka, in the polynomial form
// of B. Wrensch, "Minimal AgX Implementation", 2023.
#pragma once

#include <array>
#include <string_view>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

enum class ToneCurve {
  kNone,  ///< highlights are clipped to white
  /// Compresses values above 0.8 and keeps base colours, for pictures of products.
  kNeutral,
  /// Maps 16.5 stops and fades highlights to white, as in photographs.
  kAgx,
};

inline constexpr std::array<std::string_view, 3> kToneNames{"none", "neutral", "agx"};  ///< in the order of ToneCurve

struct Tone {
  float exposure_ev = 0.0f;  ///< in stops: light is multiplied by 2^exposure_ev
  ToneCurve curve = ToneCurve::kNone;
  bool is_identity() const { return exposure_ev == 0.0f && curve == ToneCurve::kNone; }
};

/// Maps linear scene light to linear display light. With a curve, finite colours are mapped to [0, 1].
Vec3f apply_tone(const Tone& tone, Vec3f color);

void apply_tone(const Tone& tone, Image& film);

}  // namespace lippmann
