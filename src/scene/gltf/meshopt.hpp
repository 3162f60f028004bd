#pragma once

#include <optional>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

std::optional<PackedView> packed_view(Value view);

/// Returns whether a buffer only contains uncompressed copies for readers without the extension. Such a buffer may lack data,
/// so it is not loaded.
bool is_fallback(Value buffer);

/// Checks that compressed views lie inside their buffers and are large enough for the number of elements they state. Throws
/// Error at the view.
void check_packed_views(const Document& document);

void unpack_views(Document& document);

}  // namespace lippmann::gltf
