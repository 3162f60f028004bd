#pragma once

#include <string>
#include <vector>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

std::vector<std::string> variant_names(const Document& document);

/// Returns the index of the variant that `wanted`, a name or an index, selects. Returns -1 if `wanted` is empty. If no variant
/// matches, throws a usage Error that lists the names.
int choose_variant(const std::vector<std::string>& names, const std::string& wanted);

/// Returns the file's material index for a primitive in a variant, or the primitive's own material if the variant does not
/// change it or if `variant` is -1 (no variant). -1 means glTF's default material. `where` names the primitive in errors.
int material_in(Value primitive, int variant, const std::string& where, const Report& report);

}  // namespace lippmann::gltf
