// Helpers shared by the readers of splats and of point clouds.
#pragma once

#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Returns the first element "vertex", owned by `header`; nullptr if there is none.
const Element* vertices_of(const Header& header);

/// Skips the elements before the vertices, and warns about all other elements.
void skip_others(const std::string& name, const Header& header, Body& body, const Context& context);

/// Returns the spherical harmonic of degree 0 for a constant colour: (c - 1/2) / Y_0, with Y_0 = 1 / sqrt(4 pi).
Vec3f first_harmonic_of(Vec3f color);

/// Returns the rotation from z up to y up.
Quatf z_to_y();

}  // namespace lippmann::ply
