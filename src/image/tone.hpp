// Tone mapping from scene light to display light: exposure, and a curve for highlights brighter than white.
//
// Based on: Khronos Group, "Khronos PBR Neutral Tone Mapper", 2024 (specification); AgX by T. Sobotka, in the polynomial form
// of B. Wrensch, "Minimal AgX Implementation", 2023.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

enum class ToneCurve {
  kNone,     ///< clips highlights to white
  kNeutral,  ///< keeps colours up to 0.8 and compresses highlights; for products
  kAgx,      ///< maps 16.5 stops and fades highlights to white; for photographs
};

struct Tone {
  float exposure_ev = 0.0f;  ///< stops: light is multiplied by 2^exposure_ev
  ToneCurve curve = ToneCurve::kNone;
  bool is_identity() const { return exposure_ev == 0.0f && curve == ToneCurve::kNone; }
};

/// Maps linear scene light to linear display light. Curves return values in [0, 1] for finite colours.
Vec3f apply_tone(const Tone& tone, Vec3f color);

/// Applies to every pixel of a film with 3 channels.
void apply_tone(const Tone& tone, Image& film);

}  // namespace lippmann
