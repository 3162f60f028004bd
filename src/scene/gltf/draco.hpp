#pragma once

#include <cstdint>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

inline constexpr const char* kDraco = "KHR_draco_mesh_compression";
/// Memory that the decoder's tables need per face or vertex; an upper bound for both encoding methods.
inline constexpr std::uint64_t kDracoTableBytes = 100;

/// Decompresses all Draco primitives into new buffer views, and makes their accessors refer to these views. Call check_views()
/// first. Throws Error at the primitive.
void unpack_primitives(Document& document);

}  // namespace lippmann::gltf
