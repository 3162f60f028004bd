// Decompresses primitives compressed with Draco (KHR_draco_mesh_compression).
#pragma once

#include <cstdint>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

inline constexpr const char* kDraco = "KHR_draco_mesh_compression";
/// Memory of the decoder's tables per face or vertex, for either encoding method.
inline constexpr std::uint64_t kDracoTableBytes = 100;

/// Decompresses every packed primitive into new buffer views for its accessors. Buffer views must be checked. Throws Error at
/// the primitive.
void unpack_primitives(Document& document);

}  // namespace lippmann::gltf
