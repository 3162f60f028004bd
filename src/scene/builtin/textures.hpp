#pragma once

#include <functional>
#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

Texture paint(std::string name, int width, int height, const std::function<Vec3f(Vec2f)>& color_at);

/// Returns smooth noise in [-1, 1]. Its features are about one unit large, and it repeats after `period` units in x and y.
float noise(Vec2f p, Vec2i period, std::uint32_t seed);

/// Returns the sum of octaves of noise, each with twice the frequency and half the amplitude of the previous one. The sum is
/// about within [-1, 1].
float fractal_noise(Vec2f p, Vec2i period, int octaves, std::uint32_t seed);

Texture marble_tiles(Vec3f light, Vec3f dark);

Texture wood_boards(Vec3f light, Vec3f dark, int boards);

Texture striped_plaster(Vec3f color, Vec3f stripe, int stripes);

/// The texture shows the whole carpet once.
Texture carpet(Vec3f ground, Vec3f ornament, Vec3f border);

/// Returns land and sea of an imaginary planet with ice at the poles. u runs once around the planet. v runs from 0 at the north
/// pole to 1 at the south pole.
Texture globe(Vec3f sea, Vec3f land);

}  // namespace lippmann::builtin
