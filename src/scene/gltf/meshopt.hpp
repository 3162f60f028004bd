// Decompresses buffer views compressed by meshoptimizer (EXT_meshopt_compression).
#pragma once

#include <optional>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Returns the extension's data of a buffer view, or nothing if the view is not compressed.
std::optional<PackedView> packed_view(Value view);

/// Returns whether a buffer is only a fallback for readers without the extension. It may lack data, and the reader does not
/// fetch it.
bool is_fallback(Value buffer);

/// Checks that packed views lie inside their buffers and that their counts are possible for their sizes. Throws Error at the
/// view.
void check_packed_views(const Document& document);

/// Decompresses every packed view into a new buffer. Throws Error at the view.
void unpack_views(Document& document);

}  // namespace lippmann::gltf
