// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 3.9 "Materials"; KHR_materials_unlit,
// KHR_materials_emissive_strength, KHR_materials_ior, KHR_materials_transmission.
#include "scene/gltf/material.hpp"

#include <algorithm>

#include "scene/gltf/texture.hpp"

namespace lippmann::gltf {
namespace {

float unit_factor(double x) { return static_cast<float>(std::clamp(x, 0.0, 1.0)); }

/// A number of a material's extension, checked by the schema where it is present.
double extension_number(const tinygltf::Material& material, const char* extension, const char* name, double otherwise) {
  const auto found = material.extensions.find(extension);
  if (found == material.extensions.end() || !found->second.Has(name)) return otherwise;
  return found->second.Get(name).GetNumberAsDouble();
}

void name_what_is_left_out(const tinygltf::Material& material, const std::string& where, Report& report) {
  const auto left_out = [&](bool present, const char* what) {
    if (present) report.not_supported(what, "the material's factors are used alone", where);
  };
  left_out(material.normalTexture.index >= 0, "normal textures are");
  left_out(material.occlusionTexture.index >= 0, "occlusion textures are");
  left_out(material.pbrMetallicRoughness.metallicRoughnessTexture.index >= 0, "metallic-roughness textures are");
  const auto transmission = material.extensions.find("KHR_materials_transmission");
  left_out(transmission != material.extensions.end() && transmission->second.Has("transmissionTexture"),
           "transmission textures are");
}

class MaterialReader {
 public:
  MaterialReader(Document& document, Scene& scene) : document_(document), textures_(document, scene) {}

  /// Also says which set of texture coordinates the textures need.
  Material read(std::size_t index, int& uv_set) {
    const tinygltf::Material& from = document_.model.materials[index];
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    const std::string where = element("materials", index);
    MetallicRoughness surface;
    for (int i = 0; i < 4; ++i) surface.base_color[i] = unit_factor(pbr.baseColorFactor[static_cast<std::size_t>(i)]);
    surface.metallic = unit_factor(pbr.metallicFactor);
    surface.roughness = unit_factor(pbr.roughnessFactor);
    const float strength =
        static_cast<float>(extension_number(from, "KHR_materials_emissive_strength", "emissiveStrength", 1.0));
    for (int i = 0; i < 3; ++i) surface.emissive[i] = strength * unit_factor(from.emissiveFactor[static_cast<std::size_t>(i)]);
    surface.ior = read_ior(from);
    surface.transmission = unit_factor(extension_number(from, "KHR_materials_transmission", "transmissionFactor", 0.0));
    surface.alpha_cutoff = from.alphaMode == "MASK" ? static_cast<float>(from.alphaCutoff) : 0.0f;
    surface.blend = from.alphaMode == "BLEND";
    surface.double_sided = from.doubleSided;
    surface.unlit = from.extensions.contains("KHR_materials_unlit");
    read_textures(from, where, surface, uv_set);
    name_what_is_left_out(from, where, document_.report);
    return {from.name, surface};
  }

 private:
  /// 0 stands for "reflects everything" (KHR_materials_ior); a very dense medium comes close to that.
  static float read_ior(const tinygltf::Material& from) {
    constexpr double kMirrorLike = 1000.0;
    const double ior = extension_number(from, "KHR_materials_ior", "ior", 1.5);
    return static_cast<float>(ior == 0.0 ? kMirrorLike : std::max(ior, 1.0));
  }

  void read_textures(const tinygltf::Material& from, const std::string& where, MetallicRoughness& surface, int& uv_set) {
    const tinygltf::TextureInfo& base = from.pbrMetallicRoughness.baseColorTexture;
    const tinygltf::TextureInfo& emissive = from.emissiveTexture;
    if (base.index >= 0) surface.base_color_map.texture = textures_.read(base.index);
    if (emissive.index >= 0 && surface.emissive != Vec3f(0.0f)) surface.emissive_map.texture = textures_.read(emissive.index);
    uv_set = surface.base_color_map.texture >= 0 ? base.texCoord : surface.emissive_map.texture >= 0 ? emissive.texCoord : 0;
    if (surface.emissive_map.texture >= 0 && emissive.texCoord != uv_set)
      document_.report.not_supported("several sets of texture coordinates in one material are",
                                     "the base colour's set is used for all textures", where);
  }

  Document& document_;
  TextureReader textures_;
};

}  // namespace

MaterialTable read_materials(Document& document, Scene& scene) {
  MaterialTable table;
  MaterialReader reader(document, scene);
  for (std::size_t i = 0; i < document.model.materials.size(); ++i) {
    int uv_set = 0;
    scene.materials.push_back(reader.read(i, uv_set));
    table.uv_set.push_back(uv_set);
  }
  return table;
}

int material_of(int file_material, MaterialTable& table, Scene& scene) {
  if (file_material >= 0) return file_material;
  if (table.default_material < 0) {
    table.default_material = static_cast<int>(scene.materials.size());
    table.uv_set.push_back(0);
    scene.materials.push_back({"glTF default", MetallicRoughness{}});
  }
  return table.default_material;
}

}  // namespace lippmann::gltf
