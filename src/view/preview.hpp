// A small quilt that a page shows until the whole one is there: the same views with fewer pixels, in some ten kilobytes.
#pragma once

#include <optional>
#include <string>

#include "lippmann/image/image.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// The size of a view in the preview, in pixels; none: the quilt is small enough to be waited for.
std::optional<Vec2i> preview_view_size(const PageFacts& facts);

/// The mean codes of blocks of a quilt as `facts` describes it. Needs preview_view_size(facts).
Image8 preview_of(const Image8& quilt, const PageFacts& facts);

/// preview_of as a file (lossy WebP, "image/webp").
std::string encoded_preview(const Image8& quilt, const PageFacts& facts);

}  // namespace lippmann
