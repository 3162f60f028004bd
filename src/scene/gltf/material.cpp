// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 3.9 "Materials", and the extensions KHR_materials_unlit,
// _emissive_strength, _ior, _transmission, _specular, _clearcoat, _volume, _sheen, _anisotropy, _iridescence,
// _diffuse_transmission, _dispersion, _pbrSpecularGlossiness.
#include "scene/gltf/material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/gltf/texture_map.hpp"

namespace lippmann::gltf {
namespace {

float unit_factor(Value factor, double otherwise) { return static_cast<float>(std::clamp(factor.number(otherwise), 0.0, 1.0)); }

/// Reads a colour, clamped to 0 ... 1 because exporters may write factors slightly above 1.
template <class V>
V unit_color(Value color, V otherwise) {
  return glm::clamp(color.vector(otherwise), V(0.0f), V(1.0f));
}

class MaterialReader {
 public:
  MaterialReader(Document& document, Scene& scene) : document_(document), textures_(document, scene) {}

  void decode_textures() { textures_.decode(); }

  Material read(std::size_t index, MaterialNeeds& needs) {
    const Value from = document_.root["materials"].at(index);
    MetallicRoughness surface;
    const std::string& alpha = from["alphaMode"].text();
    surface.alpha_cutoff = alpha == "MASK" ? static_cast<float>(from["alphaCutoff"].number(0.5)) : 0.0f;
    surface.blend = alpha == "BLEND";
    surface.double_sided = from["doubleSided"].flag(false);
    surface.unlit = static_cast<bool>(from.extension("KHR_materials_unlit"));
    read_base(from, surface);
    read_emission(from, surface);
    if (!surface.unlit) {
      read_relief(from, surface);
      read_transmission(from, element("materials", index), surface);
      read_specular(from, surface);
      read_clearcoat(from, surface);
      read_extensions(from, surface);
      if (const Value old = from.extension("KHR_materials_pbrSpecularGlossiness")) read_specular_glossiness(old, surface);
    }
    needs.uv_sets = choose_uv_sets(surface, element("materials", index), document_.report);
    needs.tangents = surface.normal_map.texture >= 0 || surface.clearcoat_normal_map.texture >= 0 ||
                     (surface.extensions && surface.extensions->anisotropy.strength > 0.0f);
    return {from["name"].text(), surface};
  }

 private:
  TextureMap color(Value info) { return read_map(info, true, textures_); }
  TextureMap data(Value info) { return read_map(info, false, textures_); }

  void read_base(Value from, MetallicRoughness& surface) {
    const Value pbr = from["pbrMetallicRoughness"];
    surface.base_color = unit_color(pbr["baseColorFactor"], Vec4f(1.0f));
    surface.base_color_map = color(pbr["baseColorTexture"]);
    surface.metallic = unit_factor(pbr["metallicFactor"], 1.0);
    surface.roughness = unit_factor(pbr["roughnessFactor"], 1.0);
    if (!surface.unlit) surface.metallic_roughness_map = data(pbr["metallicRoughnessTexture"]);
  }

  void read_emission(Value from, MetallicRoughness& surface) {
    const Value strength = from.extension("KHR_materials_emissive_strength")["emissiveStrength"];
    surface.emissive = static_cast<float>(strength.number(1.0)) * unit_color(from["emissiveFactor"], Vec3f(0.0f));
    if (surface.emissive != Vec3f(0.0f)) surface.emissive_map = color(from["emissiveTexture"]);
  }

  void read_relief(Value from, MetallicRoughness& surface) {
    surface.normal_map = data(from["normalTexture"]);
    surface.normal_scale = static_cast<float>(from["normalTexture"]["scale"].number(1.0));
    surface.occlusion_map = data(from["occlusionTexture"]);
    surface.occlusion_strength = unit_factor(from["occlusionTexture"]["strength"], 1.0);
  }

  void read_transmission(Value from, const std::string& where, MetallicRoughness& surface) {
    const Value extension = from.extension("KHR_materials_transmission");
    surface.ior = ior_of(checked_ior(from, where));
    surface.transmission = unit_factor(extension["transmissionFactor"], 0.0);
    if (surface.transmission > 0.0f) surface.transmission_map = data(extension["transmissionTexture"]);
  }

  /// Returns the index of refraction, or 0 if the file gives 0. An index between 0 and 1 is replaced by 1, with a warning.
  double checked_ior(Value from, const std::string& where) {
    const double ior = from.extension("KHR_materials_ior")["ior"].number(1.5);
    if (ior == 0.0 || ior >= 1.0) return ior;
    const std::string name = from["name"].text().empty() ? where : fmt::format("{} {}", where, shown(from["name"].text()));
    document_.report.warn_at("an ior between 0 and 1 is replaced by 1, without refraction or reflection", name);
    return 1.0;
  }

  static constexpr float kMirrorLike = 1000.0f;

  /// In KHR_materials_ior, 0 means full reflection at all angles, which a very high index approximates.
  static float ior_of(double ior) { return ior == 0.0 ? kMirrorLike : static_cast<float>(ior); }

  void read_specular(Value from, MetallicRoughness& surface) {
    const Value extension = from.extension("KHR_materials_specular");
    surface.specular = unit_factor(extension["specularFactor"], 1.0);
    surface.specular_map = data(extension["specularTexture"]);
    surface.specular_color = extension["specularColorFactor"].vector(Vec3f(1.0f));
    surface.specular_color_map = color(extension["specularColorTexture"]);
  }

  void read_clearcoat(Value from, MetallicRoughness& surface) {
    const Value extension = from.extension("KHR_materials_clearcoat");
    surface.clearcoat = unit_factor(extension["clearcoatFactor"], 0.0);
    if (!(surface.clearcoat > 0.0f)) return;
    surface.clearcoat_map = data(extension["clearcoatTexture"]);
    surface.clearcoat_roughness = unit_factor(extension["clearcoatRoughnessFactor"], 0.0);
    surface.clearcoat_roughness_map = data(extension["clearcoatRoughnessTexture"]);
    const Value normal = extension["clearcoatNormalTexture"];
    surface.clearcoat_normal_map = data(normal);
    surface.clearcoat_normal_scale = static_cast<float>(normal["scale"].number(1.0));
  }

  /// Reads sheen, anisotropy, iridescence, diffuse transmission, volume and dispersion. If none of these has an effect, leaves
  /// surface.extensions empty.
  void read_extensions(Value from, MetallicRoughness& surface) {
    SurfaceExtensions e;
    read_sheen(from.extension("KHR_materials_sheen"), e.sheen);
    read_anisotropy(from.extension("KHR_materials_anisotropy"), e.anisotropy);
    read_iridescence(from.extension("KHR_materials_iridescence"), e.iridescence);
    read_diffuse_transmission(from.extension("KHR_materials_diffuse_transmission"), e.diffuse_transmission);
    const bool passes = surface.transmission > 0.0f || e.diffuse_transmission.share > 0.0f;
    const Value volume = from.extension("KHR_materials_volume");
    if (volume && passes) e.volume = read_volume(volume);
    const bool is_thin = e.volume && !e.volume->is_solid;
    const bool refracts = surface.transmission > 0.0f && !is_thin && surface.ior < kMirrorLike;
    if (refracts) e.dispersion = static_cast<float>(from.extension("KHR_materials_dispersion")["dispersion"].number(0.0));
    if (e.sheen.color != Vec3f(0.0f) || e.anisotropy.strength > 0.0f || e.iridescence.share > 0.0f ||
        e.diffuse_transmission.share > 0.0f || e.volume || e.dispersion > 0.0f)
      surface.extensions = e;
  }

  /// Uses only the sign of thicknessFactor, because ray tracing finds the actual thickness.
  static Volume read_volume(Value extension) {
    Volume volume;
    volume.is_solid = extension["thicknessFactor"].number(0.0) > 0.0;
    volume.attenuation_color = unit_color(extension["attenuationColor"], Vec3f(1.0f));
    // Exporters write 0 for "no attenuation". A distance of 0 would make the volume opaque.
    const float distance = static_cast<float>(extension["attenuationDistance"].number(0.0));
    volume.attenuation_distance = distance > 0.0f ? distance : kInfinity;
    return volume;
  }

  void read_sheen(Value extension, Sheen& sheen) {
    sheen.color = unit_color(extension["sheenColorFactor"], Vec3f(0.0f));
    if (sheen.color == Vec3f(0.0f)) return;
    sheen.color_map = color(extension["sheenColorTexture"]);
    sheen.roughness = unit_factor(extension["sheenRoughnessFactor"], 0.0);
    sheen.roughness_map = data(extension["sheenRoughnessTexture"]);
  }

  void read_anisotropy(Value extension, Anisotropy& anisotropy) {
    anisotropy.strength = unit_factor(extension["anisotropyStrength"], 0.0);
    if (!(anisotropy.strength > 0.0f)) return;
    anisotropy.rotation = static_cast<float>(extension["anisotropyRotation"].number(0.0));
    anisotropy.map = data(extension["anisotropyTexture"]);
  }

  void read_iridescence(Value extension, Iridescence& iridescence) {
    iridescence.share = unit_factor(extension["iridescenceFactor"], 0.0);
    if (!(iridescence.share > 0.0f)) return;
    iridescence.map = data(extension["iridescenceTexture"]);
    iridescence.ior = static_cast<float>(extension["iridescenceIor"].number(1.3));
    iridescence.least_thickness_nm = static_cast<float>(extension["iridescenceThicknessMinimum"].number(100.0));
    iridescence.most_thickness_nm = static_cast<float>(extension["iridescenceThicknessMaximum"].number(400.0));
    iridescence.thickness_map = data(extension["iridescenceThicknessTexture"]);
  }

  void read_diffuse_transmission(Value extension, DiffuseTransmission& transmission) {
    transmission.share = unit_factor(extension["diffuseTransmissionFactor"], 0.0);
    if (!(transmission.share > 0.0f)) return;
    transmission.map = data(extension["diffuseTransmissionTexture"]);
    transmission.color = unit_color(extension["diffuseTransmissionColorFactor"], Vec3f(1.0f));
    transmission.color_map = color(extension["diffuseTransmissionColorTexture"]);
  }

  /// Converts KHR_materials_pbrSpecularGlossiness to a dielectric with a very high index of refraction, so that the specular
  /// colour alone determines the reflectance. The file's metallic-roughness properties are only meant for readers without this
  /// extension.
  void read_specular_glossiness(Value old, MetallicRoughness& surface) {
    surface.metallic = 0.0f;
    surface.ior = ior_of(0.0);
    surface.specular = 1.0f;
    surface.specular_map = {};
    surface.base_color = unit_color(old["diffuseFactor"], Vec4f(1.0f));
    surface.base_color_map = color(old["diffuseTexture"]);
    surface.specular_color = old["specularFactor"].vector(Vec3f(1.0f));
    const Value both = old["specularGlossinessTexture"];
    surface.specular_color_map = color(both);
    const float glossiness = unit_factor(old["glossinessFactor"], 1.0);
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
  for (std::size_t i = 0; i < document.root["materials"].size(); ++i) {
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
