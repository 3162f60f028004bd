// Procedural textures: stone, wood, plaster, a carpet, a globe. All repeat seamlessly in u and v.
#pragma once

#include <functional>
#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// Calls `color_at` with the (u, v) of every texel's centre, in [0, 1). `color_at` returns linear colours, which are clamped to
/// [0, 1].
Texture paint(std::string name, int width, int height, const std::function<Vec3f(Vec2f)>& color_at);

/// Returns smooth noise in [-1, 1] that repeats after `period` units in x and y, with features of about one unit.
float noise(Vec2f p, Vec2i period, std::uint32_t seed);

/// Returns the sum of octaves of noise, each with twice the frequency and half the amplitude of the one before. The sum is
/// within about [-1, 1].
float fractal_noise(Vec2f p, Vec2i period, int octaves, std::uint32_t seed);

/// Returns two by two tiles of light and dark veined stone with thin joints.
Texture marble_tiles(Vec3f light, Vec3f dark);

/// Returns boards along v with grain and joints.
Texture wood_boards(Vec3f light, Vec3f dark, int boards);

/// Returns plain plaster with faint vertical stripes, like wallpaper.
Texture striped_plaster(Vec3f color, Vec3f stripe, int stripes);

/// Returns a woven carpet with a border and a rhombic pattern, for a rectangle that it covers once.
Texture carpet(Vec3f ground, Vec3f ornament, Vec3f border);

/// Returns land and sea of an imaginary planet with ice at the poles. u runs once around, v from the north pole (0) to the
/// south pole (1).
Texture globe(Vec3f sea, Vec3f land);

}  // namespace lippmann::builtin
