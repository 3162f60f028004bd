// Computes LDR-FLIP, the difference that a viewer perceives between two alternating images.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns the mean FLIP, from 0 (equal images) to 1. The images are sRGB, have one size, and are seen at 67 pixels per degree.
double flip(const Image8& reference, const Image8& test);

}  // namespace lippmann
