// Decompresses buffer views that meshoptimizer has packed (EXT_meshopt_compression).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Takes the extension out of the JSON's buffer views, into document.packed_views.
void take_packed_views(nlohmann::json& root, Document& document);

/// Whether a buffer is only there for readers without this extension: it need not have bytes, and they are not fetched.
bool is_fallback(const nlohmann::json& buffer);

/// Refuses views that lie outside their buffers, or whose counts do not come out of so many bytes. Throws Error at the view.
void check_packed_views(const Document& document);

/// Gives every packed view of the model a buffer of its own, with the decompressed bytes. Throws Error at the view.
void unpack_views(Document& document);

}  // namespace lippmann::gltf
