#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "scene/left_out.hpp"

namespace lippmann {

struct IesProfile {
  PhotometricWeb web;  ///< all zero if the lamp emits nothing
  /// Mean intensity over the sphere, equal to lumens / 4 pi. The intensities in `web` are relative to it.
  float mean_candela = 0.0f;
  LeftOut left_out;  ///< ignored contents: unknown keywords, the tilt, data after the last candela value
};

/// Parses a file; `name` names it in messages. The zero direction of both angles is the light's -z axis. Type C: polar angles
/// count from -z, azimuths from +x towards +y. Types A and B: horizontal angles grow towards +x, vertical angles towards +y.
///
/// Half or a quarter of a symmetric distribution is completed by symmetry. The candela multiplier is applied. The tilt, the
/// size of the luminaire and the lumens of the lamp are ignored.
///
/// Throws Error naming `name` and the line if the text is not an IES file, or if its angles or candelas are invalid.
IesProfile parse_ies(const std::string& name, std::string text);

}  // namespace lippmann
