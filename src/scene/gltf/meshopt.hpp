// Decompresses buffer views that meshoptimizer has packed (EXT_meshopt_compression).
#pragma once

#include <optional>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// The extension of a buffer view of the file; none where it is not packed.
std::optional<PackedView> packed_view(Value view);

/// Whether a buffer is only there for readers without this extension: it need not have bytes, and they are not fetched.
bool is_fallback(Value buffer);

/// Refuses views that lie outside their buffers, or whose counts do not come out of so many bytes. Throws Error at the view.
void check_packed_views(const Document& document);

/// Gives every packed view a buffer of its own, with the decompressed bytes. Throws Error at the view.
void unpack_views(Document& document);

}  // namespace lippmann::gltf
