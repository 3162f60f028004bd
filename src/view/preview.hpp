// Makes a small quilt of about 10 kB, which a page shows while it loads the full one.
#pragma once

#include <optional>
#include <string>

#include "lippmann/image/image.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns the size of a view in the preview, pixels. None if the quilt is small enough without a preview.
std::optional<Vec2i> preview_view_size(const PageFacts& facts);

/// Returns the block means of the quilt described by `facts`. Needs preview_view_size(facts).
Image8 preview_of(const Image8& quilt, const PageFacts& facts);

/// Returns preview_of() encoded as lossy WebP ("image/webp").
std::string encoded_preview(const Image8& quilt, const PageFacts& facts);

}  // namespace lippmann
