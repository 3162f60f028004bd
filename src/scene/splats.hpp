#pragma once

#include <cstddef>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Splats are invisible where their coverage is below this alpha: one 8-bit step.
inline constexpr float kLeastAlpha = 1.0f / 255.0f;

bool has_splats(const Scene& scene);

constexpr std::size_t harmonics_of(int degree) { return static_cast<std::size_t>((degree + 1) * (degree + 1)); }

/// Returns the radius beyond which a splat with this opacity is invisible, in standard deviations. 0: the splat is invisible.
float reach_of_splat(float opacity);

/// Returns whether the numbers of splat i are finite and in a safe range, its deviations are non-zero, and its rotation is a
/// unit quaternion.
bool is_sound(const Splats& splats, std::size_t i);

/// Normalises all rotations and replaces zero deviations along single axes. Then removes the splats that fail is_sound(), and
/// returns their number.
std::size_t drop_unsound(Splats& splats);

void sort_by_place(Splats& splats);

Material splat_material();

/// Returns a splat's principal axes after the transform `a`, as matrix columns as long as one standard deviation. Uses double
/// precision because splats may be very flat.
glm::dmat3 axes_of_splat(const Splats& splats, std::size_t i, const Affine3f& a);

Bounds3f whole_bounds(const Splats& splats, const Affine3f& a);

/// Returns the bounds of all splats except outliers. The range of an axis holds the middle 96 % of the centres, weighted by
/// opacity. The centre of an outlier lies outside the range of some axis by more than a quarter of the length of the range.
Bounds3f bulk_bounds(const Splats& splats, const Affine3f& a);

/// Returns the number of visible splats that are more than 20 diagonals of the bulk bounds away from these bounds.
std::size_t count_far_splats(const Splats& splats);

}  // namespace lippmann
