// Based on: Khronos Group, KHR_materials_variants.
#include "scene/gltf/variants.hpp"

#include <algorithm>

#include "lippmann/core/error.hpp"
#include "scene/gltf/choice.hpp"

namespace lippmann::gltf {
namespace {

constexpr const char* kExtension = "KHR_materials_variants";

std::vector<int> variants_of(const tinygltf::Value& mapping) {
  std::vector<int> variants;
  const tinygltf::Value& list = mapping.Get("variants");
  for (int i = 0; i < static_cast<int>(list.ArrayLen()); ++i) variants.push_back(list.Get(i).GetNumberAsInt());
  return variants;
}

}  // namespace

std::vector<std::string> variant_names(const Document& document) {
  std::vector<std::string> names;
  const auto found = document.model.extensions.find(kExtension);
  if (found == document.model.extensions.end()) return names;
  const tinygltf::Value& list = found->second.Get("variants");
  for (int i = 0; i < static_cast<int>(list.ArrayLen()); ++i) names.push_back(list.Get(i).Get("name").Get<std::string>());
  return names;
}

int choose_variant(const std::vector<std::string>& names, const std::string& wanted) {
  if (wanted.empty()) return -1;
  if (names.empty())
    throw usage_error("variant", "has no effect: the file has no material variants", "a glTF file with KHR_materials_variants");
  return static_cast<int>(choose("variant", names, wanted));
}

int material_in(const tinygltf::Primitive& primitive, int variant, const std::string& where, const Report& report) {
  const auto found = primitive.extensions.find(kExtension);
  if (variant < 0 || found == primitive.extensions.end()) return primitive.material;
  const tinygltf::Value& mappings = found->second.Get("mappings");
  int material = -1;
  for (int i = 0; i < static_cast<int>(mappings.ArrayLen()); ++i) {
    const std::vector<int> variants = variants_of(mappings.Get(i));
    if (std::find(variants.begin(), variants.end(), variant) == variants.end()) continue;
    if (material >= 0) report.fail(where, "has two materials for one variant");
    material = mappings.Get(i).Get("material").GetNumberAsInt();
  }
  return material >= 0 ? material : primitive.material;
}

}  // namespace lippmann::gltf
