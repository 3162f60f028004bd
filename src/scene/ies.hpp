// Reads photometric files of lamps (IES LM-63, 1986 to 2019): types A, B and C.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "scene/left_out.hpp"

namespace lippmann {

struct IesProfile {
  PhotometricWeb web;         ///< all zero if the lamp emits nothing
  float mean_candela = 0.0f;  ///< mean over the sphere (lumens / 4 pi), to which the web's intensities are relative
  LeftOut left_out;           ///< unknown keywords, the tilt, and data after the last candela value
};

/// Parses a file; `name` names it in messages. The zero direction of both angles is the light's -z. Type C: polar angles count
/// from -z, azimuths from +x towards +y. Types A and B: horizontal angles grow towards +x, vertical angles towards +y. If a
/// file describes half or a quarter of a symmetric distribution, the rest is completed. Candela multipliers are applied; tilt,
/// luminaire size and lamp lumens are ignored.
/// Throws Error naming `name` and the line if the text is not such a file or its angles and candelas are invalid.
IesProfile parse_ies(const std::string& name, std::string text);

}  // namespace lippmann
