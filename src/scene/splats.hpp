// Utilities for splats (3D Gaussians): validity, visibility and bounds.
#pragma once

#include <cstddef>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Splats are invisible where their coverage is below kLeastAlpha.
inline constexpr float kLeastAlpha = 1.0f / 255.0f;

/// Returns whether an instance of the scene shows splats.
bool has_splats(const Scene& scene);

/// Returns the number of spherical harmonics per splat.
constexpr std::size_t harmonics_of(int degree) { return static_cast<std::size_t>((degree + 1) * (degree + 1)); }

/// Returns the visible radius of a splat with the given opacity, in standard deviations; 0: invisible.
float reach_of_splat(float opacity);

/// Returns whether splat i has finite numbers in a safe range, non-zero deviations and a unit rotation.
bool is_sound(const Splats& splats, std::size_t i);

/// Normalises rotations and replaces zero deviations along single axes, then removes splats that are still invalid and returns
/// their number. All vectors must have matching lengths.
std::size_t drop_unsound(Splats& splats);

/// Reorders splats along a space-filling curve, so that neighbouring rays find their splats in the cache.
void sort_by_place(Splats& splats);

/// Returns the unlit material of splats.
Material splat_material();

/// Returns a splat's principal axes after the transform `a`, as columns. The length of an axis is one standard deviation.
/// Computed in double precision, because splats may be very flat.
glm::dmat3 axes_of_splat(const Splats& splats, std::size_t i, const Affine3f& a);

/// Returns the bounds of the visible part of the splats after the transform `a`.
Bounds3f whole_bounds(const Splats& splats, const Affine3f& a);

/// Returns the bounds without outliers, which are common in captures. Along each axis, the middle 96 % of the centres (weighted
/// by opacity) define a range; centres that are outside it by more than a quarter of its length are outliers.
Bounds3f bulk_bounds(const Splats& splats, const Affine3f& a);

/// Returns the number of visible splats that are more than 20 diagonals away from the bulk bounds.
std::size_t count_far_splats(const Splats& splats);

}  // namespace lippmann
