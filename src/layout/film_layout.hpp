#pragma once

#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns how views are arranged in the film, the image that is rendered for given optics. Throws a usage Error naming
/// `where` for optics whose views do not consist of whole pixels, such as slanted lenses.
ViewLayout film_layout(const Optics& optics, const char* where);

}  // namespace lippmann
