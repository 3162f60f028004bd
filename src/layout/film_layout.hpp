// The views as they lie in the film of a set of optics.
#pragma once

#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Tiles of a quilt, or the pixels below each lens. Throws a usage Error naming `where` for optics that have no views of whole
/// pixels.
ViewLayout film_layout(const Optics& optics, const char* where);

}  // namespace lippmann
