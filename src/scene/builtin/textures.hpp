// Textures computed from formulas: stone, wood, plaster, a carpet, a globe. All repeat without a seam in u and v.
#pragma once

#include <functional>
#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// Calls `color_at` with the (u, v) of every texel's centre, in [0, 1); what it returns is linear and is clamped to [0, 1].
Texture paint(std::string name, int width, int height, const std::function<Vec3f(Vec2f)>& color_at);

/// Smooth noise in [-1, 1] that repeats after `period` units in x and y; one feature is about one unit wide.
float noise(Vec2f p, Vec2i period, std::uint32_t seed);

/// The sum of `octaves` of noise, each twice as fine and half as strong as the one before; in about [-1, 1].
float fractal_noise(Vec2f p, Vec2i period, int octaves, std::uint32_t seed);

/// Two by two tiles of veined stone, light and dark, with fine joints.
Texture marble_tiles(Vec3f light, Vec3f dark);

/// Boards along v with grain and joints.
Texture wood_boards(Vec3f light, Vec3f dark, int boards);

/// Even plaster with faint vertical stripes, as a wallpaper has.
Texture striped_plaster(Vec3f color, Vec3f stripe, int stripes);

/// A woven carpet: a border and a rhombic pattern; for a rectangle that it covers once.
Texture carpet(Vec3f ground, Vec3f ornament, Vec3f border);

/// Land and sea of a made-up planet, with ice at the poles; u once around, v from the north pole (0) to the south pole (1).
Texture globe(Vec3f sea, Vec3f land);

}  // namespace lippmann::builtin
