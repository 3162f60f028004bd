// The landing rule (reuse/landing.hpp) that suits given optics.
#pragma once

#include <variant>

#include "reuse/landing.hpp"
#include "reuse/slanted_landing.hpp"

namespace lippmann {

using AnyLanding = std::variant<GridLanding, SheetLanding<SplatMode::kView>, SheetLanding<SplatMode::kLens>,
                                SquareLanding<SplatMode::kView>, SquareLanding<SplatMode::kLens>,
                                HexagonLanding<SplatMode::kView>, HexagonLanding<SplatMode::kLens>, SlantedLanding>;

/// `optics` must pass validate(). Throws a usage Error for slanted panels whose sub-pixels do not lie in stripes, and for
/// points that are to stay below their lenses.
AnyLanding make_landing(const Optics& optics, SplatMode mode);

}  // namespace lippmann
