#pragma once

#include <string>
#include <vector>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

std::vector<std::string> variant_names(const Document& document);

/// Returns the index of the variant that `wanted`, a name or an index, selects. Returns -1 if `wanted` is empty. If no variant
/// matches, throws a usage Error that lists the names.
int choose_variant(const std::vector<std::string>& names, const std::string& wanted);

/// Returns the file's index of a primitive's material in a variant, or -1 for glTF's default material. If the variant does not
/// change the material, or if `variant` is -1 (no variant), returns the primitive's own material. `where` names the primitive
/// in errors.
int material_in(Value primitive, int variant, const std::string& where, const Report& report);

}  // namespace lippmann::gltf
