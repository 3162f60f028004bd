// Reads the material variants of a glTF file (KHR_materials_variants).
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

std::vector<std::string> variant_names(const Document& document);

/// Returns the index of the variant; -1 if `wanted` is empty. `wanted`: a name or an index. Throws a usage Error that lists the
/// names if there is no match.
int choose_variant(const std::vector<std::string>& names, const std::string& wanted);

/// Returns the file's index of a primitive's material in a variant (-1: no variant), or -1 for glTF's default material. `where`
/// names the primitive.
int material_in(Value primitive, int variant, const std::string& where, const Report& report);

}  // namespace lippmann::gltf
