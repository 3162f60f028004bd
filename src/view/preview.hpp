// Makes a small quilt of 10 to 60 kB, which a page shows while it loads the full one.
#pragma once

#include <optional>
#include <string>

#include "lippmann/image/image.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns the size of each view in the preview, or nullopt if the quilt is so small that it needs no preview.
std::optional<Vec2i> preview_view_size(const PageFacts& facts);

/// Shrinks a quilt: each pixel of the preview is the mean of a block of pixels. Call this only if preview_view_size(facts) has
/// a value.
Image8 preview_of(const Image8& quilt, const PageFacts& facts);

std::string encoded_preview(const Image8& quilt, const PageFacts& facts);

}  // namespace lippmann
