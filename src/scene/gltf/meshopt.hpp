// Decompresses buffer views that meshoptimizer has compressed (EXT_meshopt_compression).
#pragma once

#include <optional>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Returns the extension's data of a buffer view, or none if the view is not compressed.
std::optional<PackedView> packed_view(Value view);

/// Returns whether a buffer only contains uncompressed copies for readers without the extension. Such a buffer may lack data,
/// so it is not loaded.
bool is_fallback(Value buffer);

/// Checks that compressed views lie inside their buffers and are large enough for the number of elements they state. Throws
/// Error at the view.
void check_packed_views(const Document& document);

/// Decompresses every compressed view into a new buffer. Throws Error at the view.
void unpack_views(Document& document);

}  // namespace lippmann::gltf
