// Decompresses primitives that Draco has packed (KHR_draco_mesh_compression).
#pragma once

#include <cstdint>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

inline constexpr const char* kDraco = "KHR_draco_mesh_compression";
/// Bytes of the decoder's tables for a face or a vertex, with either method.
inline constexpr std::uint64_t kDracoTableBytes = 100;

/// Gives the accessors of every packed primitive buffer views of their own, with the decompressed elements. The file's buffer
/// views have been checked. Throws Error at the primitive.
void unpack_primitives(Document& document);

}  // namespace lippmann::gltf
