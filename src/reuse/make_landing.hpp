// The landing rule (reuse/landing.hpp) that suits given optics.
#pragma once

#include <variant>

#include "reuse/landing.hpp"

namespace lippmann {

using AnyLanding =
    std::variant<GridLanding, SheetLanding<SplatMode::kView>, SheetLanding<SplatMode::kLens>, SquareLanding<SplatMode::kView>,
                 SquareLanding<SplatMode::kLens>, HexagonLanding<SplatMode::kView>, HexagonLanding<SplatMode::kLens>>;

/// `optics` must pass validate().
AnyLanding make_landing(const Optics& optics, SplatMode mode);

}  // namespace lippmann
