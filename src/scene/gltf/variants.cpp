#include "scene/gltf/variants.hpp"

#include <algorithm>

#include "lippmann/core/error.hpp"
#include "scene/gltf/choice.hpp"

namespace lippmann::gltf {
namespace {

constexpr const char* kExtension = "KHR_materials_variants";

}  // namespace

std::vector<std::string> variant_names(const Document& document) {
  return names_in(document.root.extension(kExtension)["variants"]);
}

int choose_variant(const std::vector<std::string>& names, const std::string& wanted) {
  if (wanted.empty()) return -1;
  if (names.empty())
    throw usage_error("variant", "has no effect: the file has no material variants", "a glTF file with KHR_materials_variants");
  return static_cast<int>(choose("variant", names, wanted));
}

int material_in(Value primitive, int variant, const std::string& where, const Report& report) {
  const int otherwise = primitive["material"].index();
  if (variant < 0) return otherwise;
  const Value mappings = primitive.extension(kExtension)["mappings"];
  int material = -1;
  for (std::size_t i = 0; i < mappings.size(); ++i) {
    const std::vector<int> variants = mappings.at(i)["variants"].indices();
    if (std::find(variants.begin(), variants.end(), variant) == variants.end()) continue;
    if (material >= 0) report.fail(where, "has two materials for one variant");
    material = mappings.at(i)["material"].index();
  }
  return material >= 0 ? material : otherwise;
}

}  // namespace lippmann::gltf
