// What the readers of splats and of points share: both show the vertices of a PLY file alone.
#pragma once

#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// The first element "vertex"; nullptr: none. It belongs to `header`.
const Element* vertices_of(const Header& header);

/// Passes over the elements before the vertices, and warns of all others.
void pass_over_others(const std::string& name, const Header& header, Body& body, const Context& context);

/// The first spherical harmonic that gives this colour: (c - 1/2) / Y_0, with Y_0 = 1 / sqrt(4 pi).
Vec3f first_harmonic_of(Vec3f color);

/// The rotation of a file whose z points upwards.
Quatf z_to_y();

}  // namespace lippmann::ply
