// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 3.9 "Materials"; KHR_materials_unlit, _emissive_strength,
// _ior, _transmission, _specular, _clearcoat, _volume, _sheen, _anisotropy, _iridescence, _diffuse_transmission, _dispersion,
// _pbrSpecularGlossiness.
#include "scene/gltf/material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/gltf/texture_map.hpp"

namespace lippmann::gltf {
namespace {

float unit_factor(double x) { return static_cast<float>(std::clamp(x, 0.0, 1.0)); }

/// One extension of a material; what it holds was checked by the schema. Absent: every number has its default.
class Extension {
 public:
  Extension(const tinygltf::Material& material, const char* name) {
    const auto found = material.extensions.find(name);
    if (found != material.extensions.end()) value_ = &found->second;
  }

  explicit operator bool() const { return value_ != nullptr; }
  const tinygltf::Value* find(const char* name) const { return value_ && value_->Has(name) ? &value_->Get(name) : nullptr; }
  double number(const char* name, double otherwise) const {
    const tinygltf::Value* value = find(name);
    return value ? value->GetNumberAsDouble() : otherwise;
  }
  Vec3f color(const char* name, Vec3f otherwise) const {
    const tinygltf::Value* value = find(name);
    if (!value) return otherwise;
    Vec3f color;
    for (int i = 0; i < 3; ++i) color[i] = static_cast<float>(value->Get(i).GetNumberAsDouble());
    return color;
  }
  /// With alpha; in [0, 1].
  Vec4f color4(const char* name, Vec4f otherwise) const {
    const tinygltf::Value* value = find(name);
    if (!value) return otherwise;
    Vec4f color;
    for (int i = 0; i < 4; ++i) color[i] = unit_factor(value->Get(i).GetNumberAsDouble());
    return color;
  }

 private:
  const tinygltf::Value* value_ = nullptr;
};

class MaterialReader {
 public:
  MaterialReader(Document& document, Scene& scene) : document_(document), textures_(document, scene) {}

  void decode_textures() { textures_.decode(); }

  Material read(std::size_t index, MaterialNeeds& needs) {
    const tinygltf::Material& from = document_.model.materials[index];
    MetallicRoughness surface;
    surface.alpha_cutoff = from.alphaMode == "MASK" ? static_cast<float>(from.alphaCutoff) : 0.0f;
    surface.blend = from.alphaMode == "BLEND";
    surface.double_sided = from.doubleSided;
    surface.unlit = static_cast<bool>(Extension(from, "KHR_materials_unlit"));
    read_base(from, surface);
    read_emission(from, surface);
    if (!surface.unlit) {
      read_relief(from, surface);
      read_transmission(from, element("materials", index), surface);
      read_specular(from, surface);
      read_clearcoat(from, surface);
      read_extensions(from, surface);
      if (const Extension old(from, "KHR_materials_pbrSpecularGlossiness"); old) read_specular_glossiness(old, surface);
    }
    needs.uv_sets = choose_uv_sets(surface, element("materials", index), document_.report);
    needs.tangents = surface.normal_map.texture >= 0 || surface.clearcoat_normal_map.texture >= 0 ||
                     (surface.extensions && surface.extensions->anisotropy.strength > 0.0f);
    return {from.name, surface};
  }

 private:
  TextureMap color(const MapSource& source) { return read_map(source, true, textures_); }
  TextureMap data(const MapSource& source) { return read_map(source, false, textures_); }

  void read_base(const tinygltf::Material& from, MetallicRoughness& surface) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    for (int i = 0; i < 4; ++i) surface.base_color[i] = unit_factor(pbr.baseColorFactor[static_cast<std::size_t>(i)]);
    surface.base_color_map = color(map_source(pbr.baseColorTexture));
    surface.metallic = unit_factor(pbr.metallicFactor);
    surface.roughness = unit_factor(pbr.roughnessFactor);
    if (!surface.unlit) surface.metallic_roughness_map = data(map_source(pbr.metallicRoughnessTexture));
  }

  void read_emission(const tinygltf::Material& from, MetallicRoughness& surface) {
    const Extension extension(from, "KHR_materials_emissive_strength");
    const float strength = static_cast<float>(extension.number("emissiveStrength", 1.0));
    for (int i = 0; i < 3; ++i) surface.emissive[i] = strength * unit_factor(from.emissiveFactor[static_cast<std::size_t>(i)]);
    if (surface.emissive != Vec3f(0.0f)) surface.emissive_map = color(map_source(from.emissiveTexture));
  }

  void read_relief(const tinygltf::Material& from, MetallicRoughness& surface) {
    surface.normal_map = data(map_source(from.normalTexture));
    surface.normal_scale = static_cast<float>(from.normalTexture.scale);
    surface.occlusion_map = data(map_source(from.occlusionTexture));
    surface.occlusion_strength = unit_factor(from.occlusionTexture.strength);
  }

  void read_transmission(const tinygltf::Material& from, const std::string& where, MetallicRoughness& surface) {
    const Extension extension(from, "KHR_materials_transmission");
    surface.ior = ior_of(checked_ior(from, where));
    surface.transmission = unit_factor(extension.number("transmissionFactor", 0.0));
    if (surface.transmission > 0.0f) surface.transmission_map = data(map_source(extension.find("transmissionTexture")));
  }

  /// Nothing is thinner than empty space.
  double checked_ior(const tinygltf::Material& from, const std::string& where) {
    const double ior = Extension(from, "KHR_materials_ior").number("ior", 1.5);
    if (ior == 0.0 || ior >= 1.0) return ior;
    const std::string name = from.name.empty() ? where : fmt::format("{} {}", where, shown(from.name));
    document_.report.warn_at("an ior between 0 and 1 is taken as 1, which neither bends nor mirrors light", name);
    return 1.0;
  }

  static constexpr float kMirrorLike = 1000.0f;

  /// 0 stands for "reflects everything" (KHR_materials_ior); a very dense medium comes close to that.
  static float ior_of(double ior) { return ior == 0.0 ? kMirrorLike : static_cast<float>(ior); }

  void read_specular(const tinygltf::Material& from, MetallicRoughness& surface) {
    const Extension extension(from, "KHR_materials_specular");
    surface.specular = unit_factor(extension.number("specularFactor", 1.0));
    surface.specular_map = data(map_source(extension.find("specularTexture")));
    surface.specular_color = extension.color("specularColorFactor", Vec3f(1.0f));
    surface.specular_color_map = color(map_source(extension.find("specularColorTexture")));
  }

  void read_clearcoat(const tinygltf::Material& from, MetallicRoughness& surface) {
    const Extension extension(from, "KHR_materials_clearcoat");
    surface.clearcoat = unit_factor(extension.number("clearcoatFactor", 0.0));
    if (!(surface.clearcoat > 0.0f)) return;
    surface.clearcoat_map = data(map_source(extension.find("clearcoatTexture")));
    surface.clearcoat_roughness = unit_factor(extension.number("clearcoatRoughnessFactor", 0.0));
    surface.clearcoat_roughness_map = data(map_source(extension.find("clearcoatRoughnessTexture")));
    const tinygltf::Value* normal = extension.find("clearcoatNormalTexture");
    surface.clearcoat_normal_map = data(map_source(normal));
    if (normal && normal->Has("scale"))
      surface.clearcoat_normal_scale = static_cast<float>(normal->Get("scale").GetNumberAsDouble());
  }

  /// Where none of them has an effect, the surface is left without.
  void read_extensions(const tinygltf::Material& from, MetallicRoughness& surface) {
    SurfaceExtensions e;
    read_sheen(Extension(from, "KHR_materials_sheen"), e.sheen);
    read_anisotropy(Extension(from, "KHR_materials_anisotropy"), e.anisotropy);
    read_iridescence(Extension(from, "KHR_materials_iridescence"), e.iridescence);
    read_diffuse_transmission(Extension(from, "KHR_materials_diffuse_transmission"), e.diffuse_transmission);
    const bool passes = surface.transmission > 0.0f || e.diffuse_transmission.share > 0.0f;
    const Extension volume(from, "KHR_materials_volume");
    if (volume && passes) e.volume = read_volume(volume);
    const bool is_thin = e.volume && !e.volume->is_solid;
    const bool refracts = surface.transmission > 0.0f && !is_thin && surface.ior < kMirrorLike;  // that of 0 reflects all
    if (refracts) e.dispersion = static_cast<float>(Extension(from, "KHR_materials_dispersion").number("dispersion", 0.0));
    if (e.sheen.color != Vec3f(0.0f) || e.anisotropy.strength > 0.0f || e.iridescence.share > 0.0f ||
        e.diffuse_transmission.share > 0.0f || e.volume || e.dispersion > 0.0f)
      surface.extensions = e;
  }

  /// How thick it is, rays find out; the file only says whether it is thick at all.
  static Volume read_volume(const Extension& extension) {
    Volume volume;
    volume.is_solid = extension.number("thicknessFactor", 0.0) > 0.0;
    volume.attenuation_color = glm::min(extension.color("attenuationColor", Vec3f(1.0f)), Vec3f(1.0f));
    // 0 means nothing that light could do; exporters write it for "none".
    const float distance = static_cast<float>(extension.number("attenuationDistance", 0.0));
    volume.attenuation_distance = distance > 0.0f ? distance : kInfinity;
    return volume;
  }

  void read_sheen(const Extension& extension, Sheen& sheen) {
    sheen.color = glm::min(extension.color("sheenColorFactor", Vec3f(0.0f)), Vec3f(1.0f));
    if (sheen.color == Vec3f(0.0f)) return;
    sheen.color_map = color(map_source(extension.find("sheenColorTexture")));
    sheen.roughness = unit_factor(extension.number("sheenRoughnessFactor", 0.0));
    sheen.roughness_map = data(map_source(extension.find("sheenRoughnessTexture")));
  }

  void read_anisotropy(const Extension& extension, Anisotropy& anisotropy) {
    anisotropy.strength = unit_factor(extension.number("anisotropyStrength", 0.0));
    if (!(anisotropy.strength > 0.0f)) return;
    anisotropy.rotation = static_cast<float>(extension.number("anisotropyRotation", 0.0));
    anisotropy.map = data(map_source(extension.find("anisotropyTexture")));
  }

  void read_iridescence(const Extension& extension, Iridescence& iridescence) {
    iridescence.share = unit_factor(extension.number("iridescenceFactor", 0.0));
    if (!(iridescence.share > 0.0f)) return;
    iridescence.map = data(map_source(extension.find("iridescenceTexture")));
    iridescence.ior = static_cast<float>(extension.number("iridescenceIor", 1.3));
    iridescence.least_thickness_nm = static_cast<float>(extension.number("iridescenceThicknessMinimum", 100.0));
    iridescence.most_thickness_nm = static_cast<float>(extension.number("iridescenceThicknessMaximum", 400.0));
    iridescence.thickness_map = data(map_source(extension.find("iridescenceThicknessTexture")));
  }

  void read_diffuse_transmission(const Extension& extension, DiffuseTransmission& transmission) {
    transmission.share = unit_factor(extension.number("diffuseTransmissionFactor", 0.0));
    if (!(transmission.share > 0.0f)) return;
    transmission.map = data(map_source(extension.find("diffuseTransmissionTexture")));
    transmission.color = glm::min(extension.color("diffuseTransmissionColorFactor", Vec3f(1.0f)), Vec3f(1.0f));
    transmission.color_map = color(map_source(extension.find("diffuseTransmissionColorTexture")));
  }

  /// As a dielectric that reflects everything, times the specular colour at normal incidence: the reflectance that the old
  /// model has. It replaces the metallic-roughness description, which such files bring for readers that do not know it.
  void read_specular_glossiness(const Extension& old, MetallicRoughness& surface) {
    surface.metallic = 0.0f;
    surface.ior = ior_of(0.0);
    surface.specular = 1.0f;
    surface.specular_map = {};
    surface.base_color = old.color4("diffuseFactor", Vec4f(1.0f));
    surface.base_color_map = color(map_source(old.find("diffuseTexture")));
    surface.specular_color = old.color("specularFactor", Vec3f(1.0f));
    const MapSource both = map_source(old.find("specularGlossinessTexture"));
    surface.specular_color_map = color(both);
    const float glossiness = unit_factor(old.number("glossinessFactor", 1.0));
    surface.metallic_roughness_map =
        read_map_from(both, [&](int texture) { return textures_.read_roughness(texture, glossiness); });
    surface.roughness = surface.metallic_roughness_map.texture >= 0 ? 1.0f : 1.0f - glossiness;
  }

  Document& document_;
  TextureReader textures_;
};

}  // namespace

MaterialTable read_materials(Document& document, Scene& scene) {
  MaterialTable table;
  MaterialReader reader(document, scene);
  for (std::size_t i = 0; i < document.model.materials.size(); ++i) {
    table.needs.emplace_back();
    scene.materials.push_back(reader.read(i, table.needs.back()));
  }
  reader.decode_textures();
  return table;
}

int material_of(int file_material, MaterialTable& table, Scene& scene) {
  if (file_material >= 0) return file_material;
  if (table.default_material < 0) {
    table.default_material = static_cast<int>(scene.materials.size());
    table.needs.emplace_back();
    scene.materials.push_back({"glTF default", MetallicRoughness{}});
  }
  return table.default_material;
}

}  // namespace lippmann::gltf
