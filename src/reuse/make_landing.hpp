// Selects the landing rule (reuse/landing.hpp) for given optics.
#pragma once

#include <variant>

#include "reuse/landing.hpp"
#include "reuse/slanted_landing.hpp"

namespace lippmann {

using AnyLanding = std::variant<GridLanding, SheetLanding<SplatMode::kView>, SheetLanding<SplatMode::kLens>,
                                SquareLanding<SplatMode::kView>, SquareLanding<SplatMode::kLens>,
                                HexagonLanding<SplatMode::kView>, HexagonLanding<SplatMode::kLens>, SlantedLanding>;

/// Returns the landing rule for valid `optics`. Throws a usage Error for slanted panels with SplatMode::kLens, or without
/// striped sub-pixels.
AnyLanding make_landing(const Optics& optics, SplatMode mode);

}  // namespace lippmann
