// Sets of materials that a glTF file has to choose from (KHR_materials_variants).
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

std::vector<std::string> variant_names(const Document& document);

/// Its index; -1: none is wanted. wanted: a name or an index. Throws a usage Error that lists the names where it is neither.
int choose_variant(const std::vector<std::string>& names, const std::string& wanted);

/// The file's material of a primitive in that variant (-1: in none); -1: glTF's default. where: names the primitive.
int material_in(Value primitive, int variant, const std::string& where, const Report& report);

}  // namespace lippmann::gltf
