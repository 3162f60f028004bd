// Checks the indices of a parsed glTF model.
#pragma once

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Throws Error at the first element whose required index is missing or whose index does not exist. The schema has checked the
/// JSON already; versions of tinygltf differ in what they make of it, and write -1 for an index that is missing. After it, only
/// indices that glTF lets a file omit may be -1: an animation channel's node, a primitive's indices and material, and so on.
void check_indices(const Document& document);

}  // namespace lippmann::gltf
