// Reads photometric files of lamps (IES LM-63, 1986 to 2019): types A, B and C.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "scene/left_out.hpp"

namespace lippmann {

struct IesProfile {
  PhotometricWeb web;         ///< nothing in it is above 0 where the lamp sends no light
  float mean_candela = 0.0f;  ///< over the whole sphere: what the web's intensities are multiplied by; lumens over 4 pi
  LeftOut left_out;           ///< keywords that LM-63 does not have, tilt, and what follows the last candela value
};

/// The zero of both angles is the light's -z. Type C: polar angles from there, azimuths from +x towards +y. Types A and B:
/// horizontal angles towards +x, vertical ones towards +y. Symmetric halves and quarters are made whole. Tilt, the size of the
/// luminaire and its lamps' lumens change nothing; the multipliers of candelas do.
/// Throws Error, naming `name` and the line, for what is no such file, and for angles and candelas that make no web.
IesProfile parse_ies(const std::string& name, std::string text);

}  // namespace lippmann
