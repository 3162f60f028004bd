#pragma once

#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

const Element* vertices_of(const Header& header);

/// Reads past the elements before the vertices, and warns about all elements other than the vertices.
void skip_others(const std::string& name, const Header& header, Body& body, const Context& context);

/// Returns the coefficient of degree 0 that gives a splat a constant colour c: (c - 1/2) / Y_0, with Y_0 = 1 / sqrt(4 pi).
Vec3f first_harmonic_of(Vec3f color);

Quatf z_to_y();

}  // namespace lippmann::ply
