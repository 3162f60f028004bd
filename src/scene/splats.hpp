// What is asked of splats (3D Gaussians): which of them can be shown, and where they are.
#pragma once

#include <cstddef>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// A splat is seen where it covers at least so much.
inline constexpr float kLeastAlpha = 1.0f / 255.0f;

/// Whether an instance of the scene shows splats.
bool has_splats(const Scene& scene);

/// How many spherical harmonics a splat has.
constexpr std::size_t harmonics_of(int degree) { return static_cast<std::size_t>((degree + 1) * (degree + 1)); }

/// Up to how many standard deviations from its centre a splat of this opacity is seen; 0: nowhere.
float reach_of_splat(float opacity);

/// Whether splat i is made of finite numbers that can be computed with, has a size along every axis and a unit rotation.
bool is_sound(const Splats& splats, std::size_t i);

/// Makes rotations unit and sizes along single axes not 0, then takes out what is still not sound; how many these were.
/// All vectors are as long as they should be.
std::size_t drop_unsound(Splats& splats);

/// Puts splats that are near one another side by side: rays that meet one meet its neighbours next, and find them in the cache.
void sort_by_place(Splats& splats);

/// What splats have in place of a material: light makes no difference to them.
Material splat_material();

/// Where the offsets from a splat's centre that are unit vectors in standard deviations go under `a`: columns. In double
/// precision, because splats may be as flat as paper.
glm::dmat3 axes_of_splat(const Splats& splats, std::size_t i, const Affine3f& a);

/// The box around everything that is seen of the splats, taken through `a`.
Bounds3f whole_bounds(const Splats& splats, const Affine3f& a);

/// The same without those that stray: captures have some far away from everything else. Along each axis, what lies farther
/// beyond the middle 96 % of the centres (each counts as its opacity) than a quarter of their extent is left out.
Bounds3f bulk_bounds(const Splats& splats, const Affine3f& a);

/// How many splats that are seen lie outside the bulk's bounds by more than 20 times their diagonal.
std::size_t count_far_splats(const Splats& splats);

}  // namespace lippmann
