// All models of optics. A new one is included here, and its rays (and what an eye sees of it) stand in the variants below; the
// compiler then checks that it answers everything.
#pragma once

#include <utility>
#include <variant>

#include "optics/lenticular.hpp"
#include "optics/microlens.hpp"
#include "optics/model.hpp"
#include "optics/multi_view.hpp"
#include "optics/ray_table.hpp"
#include "optics/sight.hpp"
#include "optics/single_view.hpp"
#include "optics/slanted_panel.hpp"
#include "optics/slanted_sight.hpp"

namespace lippmann {

/// Constants of rays. Each has write_block() and write_ray_of(), or crossing() instead of that.
using AnyRays = std::variant<LenticularRays, SquareMicrolensRays, HexagonalMicrolensRays, MultiViewRays, SingleViewRays,
                             SlantedPanelRays, RayTableRays>;

/// What an eye sees of a panel.
using AnySight = std::variant<SlantedSight, LenticularSight, MicrolensSight, QuiltSight>;

namespace detail {

template <class>
inline constexpr bool kAllAnswer = false;
template <class... Models>
inline constexpr bool kAllAnswer<std::variant<Models...>> = (AnswersForItself<Models> && ...);

}  // namespace detail

static_assert(detail::kAllAnswer<OpticsModel>);

/// Throws a usage Error for optics without an inverse.
AnySight make_sight(const Optics& optics);

}  // namespace lippmann
