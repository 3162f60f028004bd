#pragma once

#include <utility>
#include <variant>

#include "optics/lenticular.hpp"
#include "optics/microlens.hpp"
#include "optics/model.hpp"
#include "optics/multi_view.hpp"
#include "optics/plenoptic.hpp"
#include "optics/ray_table.hpp"
#include "optics/sight.hpp"
#include "optics/single_view.hpp"
#include "optics/slanted_panel.hpp"
#include "optics/slanted_sight.hpp"

namespace lippmann {

/// The constants from which rays are computed. Each type has write_block(), and write_ray_of() or crossing(). Types of models
/// that block light also have is_blocked(constants, px, py).
using AnyRays = std::variant<LenticularRays, SquareMicrolensRays, HexagonalMicrolensRays, MultiViewRays, SingleViewRays,
                             SlantedPanelRays, RayTableRays, SquarePlenopticRays, HexagonalPlenopticRays>;

using AnySight = std::variant<SlantedSight, LenticularSight, MicrolensSight, QuiltSight>;

namespace detail {

template <class>
inline constexpr bool kAllComplete = false;
template <class... Models>
inline constexpr bool kAllComplete<std::variant<Models...>> = (CompleteModel<Models> && ...);

}  // namespace detail

static_assert(detail::kAllComplete<OpticsModel>);

/// Returns the mapping from an eye and a point of the plane z = 0 to a point of the panel. Throws a usage Error for optics
/// without an inverse mapping.
AnySight make_sight(const Optics& optics);

}  // namespace lippmann
