// From the light of a scene to the light of a display: exposure, and a curve that brings what is brighter than white into it.
//
// Based on: Khronos Group, "Khronos PBR Neutral Tone Mapper", 2024 (specification); AgX by T. Sobotka, in the polynomial
// form of B. Wrensch, "Minimal AgX Implementation", 2023.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

enum class ToneCurve {
  kNone,     ///< what is brighter than white is white
  kNeutral,  ///< colours up to 0.8 as they are, above it compressed: for products
  kAgx,      ///< all of 16.5 stops, bright colours fade to white: for photographs
};

struct Tone {
  float exposure_ev = 0.0f;  ///< light is multiplied by 2 to this
  ToneCurve curve = ToneCurve::kNone;
  bool is_identity() const { return exposure_ev == 0.0f && curve == ToneCurve::kNone; }
};

/// Display light, linear, of scene light, linear; curves give [0, 1] (of finite colours).
Vec3f apply_tone(const Tone& tone, Vec3f color);

/// Applies to every pixel of a film of 3 channels.
void apply_tone(const Tone& tone, Image& film);

}  // namespace lippmann
