// The glTF properties that the reader uses, with their types, ranges and the arrays that indices refer to.
//
// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 5 "Properties Reference", and the specifications of the
// extensions listed in gltf.hpp.
#pragma once

#include <cfloat>
#include <cstddef>
#include <span>
#include <string_view>

namespace lippmann::gltf::schema {

enum class Kind {
  kBool,
  kFlag,
  kString,
  kStrings,
  kNumber,
  kNumbers,
  kInteger,
  kIndex,
  kIndices,
  kIndexLists,  ///< an array of arrays of indices; each inner array has `length` elements
  kIndexMap,
  kIntegerMap,
  kIndexMaps,
  kObject,
  kObjects,
};

enum Need {
  kOptional,
  kRequired,
  /// The property is removed if its type is wrong, because any program may write properties into extras.
  kIfKindMatches,
};

struct Property {
  std::string_view name;
  Kind kind = Kind::kObject;
  Need need = kOptional;
  double lower = -FLT_MAX, upper = FLT_MAX;
  int multiple_of = 1;
  std::size_t length = 0;  ///< number of elements of a number array; 0: any
  std::string_view refers_to{};
  std::string_view choices{};  ///< accepted strings, as "|A|B|"; empty: any string
  std::span<const Property> object{};
};

constexpr double kMaxInt = 2147483647.0;
constexpr double kMaxBytes = 9007199254740992.0;  // 2^53: JSON numbers represent all integers up to it exactly
constexpr double kPositive = 1e-6;                // replaces "> 0" in the specification
constexpr double kOne = 1.001;                    // upper limit of factors; exporters may round up
constexpr double kHalfPi = 1.5707963267948966;
constexpr double kPi = 3.1415927;  // rounded up to a float

constexpr Property boolean(std::string_view name) { return {.name = name, .kind = Kind::kBool}; }
constexpr Property flag(std::string_view name) { return {.name = name, .kind = Kind::kFlag, .need = kIfKindMatches}; }
constexpr Property string(std::string_view name, Need need = kOptional, std::string_view choices = {}) {
  return {.name = name, .kind = Kind::kString, .need = need, .choices = choices};
}
constexpr Property number(std::string_view name, double lower, double upper, Need need = kOptional) {
  return {.name = name, .kind = Kind::kNumber, .need = need, .lower = lower, .upper = upper};
}
constexpr Property numbers(std::string_view name, std::size_t length, double lower = -FLT_MAX, double upper = FLT_MAX) {
  return {.name = name, .kind = Kind::kNumbers, .lower = lower, .upper = upper, .length = length};
}
constexpr Property integer(std::string_view name, double lower, double upper, Need need = kOptional) {
  return {.name = name, .kind = Kind::kInteger, .need = need, .lower = lower, .upper = upper};
}
constexpr Property index(std::string_view name, std::string_view refers_to, Need need = kOptional) {
  return {.name = name, .kind = Kind::kIndex, .need = need, .lower = 0.0, .upper = kMaxInt, .refers_to = refers_to};
}
constexpr Property indices(std::string_view name, std::string_view refers_to, Need need = kOptional) {
  return {.name = name, .kind = Kind::kIndices, .need = need, .lower = 0.0, .upper = kMaxInt, .refers_to = refers_to};
}
constexpr Property index_map(std::string_view name, Kind kind, Need need) {
  return {.name = name, .kind = kind, .need = need, .lower = 0.0, .upper = kMaxInt, .refers_to = "accessors"};
}
constexpr Property object(std::string_view name, std::span<const Property> properties, Need need = kOptional) {
  return {.name = name, .kind = Kind::kObject, .need = need, .object = properties};
}
constexpr Property objects(std::string_view name, std::span<const Property> properties, Need need = kOptional) {
  return {.name = name, .kind = Kind::kObjects, .need = need, .object = properties};
}

constexpr Property kPackedBuffer[] = {boolean("fallback")};
constexpr Property kBufferExtensions[] = {object("EXT_meshopt_compression", kPackedBuffer)};
constexpr Property kBuffer[] = {
    string("uri"),
    integer("byteLength", 1, kMaxBytes, kRequired),
    object("extensions", kBufferExtensions),
};

constexpr Property kPackedView[] = {
    index("buffer", "buffers", kRequired),
    integer("byteOffset", 0, kMaxBytes),
    integer("byteLength", 1, kMaxBytes, kRequired),
    integer("byteStride", 1, 256, kRequired),
    integer("count", 1, kMaxInt, kRequired),
    string("mode", kRequired, "|ATTRIBUTES|TRIANGLES|INDICES|"),
    string("filter", kOptional, "|NONE|OCTAHEDRAL|QUATERNION|EXPONENTIAL|"),
};
constexpr Property kViewExtensions[] = {object("EXT_meshopt_compression", kPackedView)};

constexpr Property kBufferView[] = {
    index("buffer", "buffers", kRequired),
    integer("byteOffset", 0, kMaxBytes),
    integer("byteLength", 1, kMaxBytes, kRequired),
    {.name = "byteStride", .kind = Kind::kInteger, .lower = 4, .upper = 252, .multiple_of = 4},
    object("extensions", kViewExtensions),
};

constexpr std::string_view kElementTypes = "|SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4|";
constexpr double kByte = 5120, kUnsignedInt = 5125, kFloat = 5126;

constexpr Property kSparseIndices[] = {
    index("bufferView", "bufferViews", kRequired),
    integer("byteOffset", 0, kMaxInt),
    integer("componentType", kByte, kUnsignedInt, kRequired),
};
constexpr Property kSparseValues[] = {index("bufferView", "bufferViews", kRequired), integer("byteOffset", 0, kMaxInt)};
constexpr Property kSparse[] = {
    integer("count", 1, kMaxInt, kRequired),
    object("indices", kSparseIndices, kRequired),
    object("values", kSparseValues, kRequired),
};
constexpr Property kAccessor[] = {
    index("bufferView", "bufferViews"),
    integer("byteOffset", 0, kMaxBytes),
    integer("componentType", kByte, kFloat, kRequired),
    boolean("normalized"),
    integer("count", 1, kMaxInt, kRequired),
    string("type", kRequired, kElementTypes),
    object("sparse", kSparse),
};

constexpr Property kDraco[] = {
    index("bufferView", "bufferViews", kRequired),
    {.name = "attributes", .kind = Kind::kIntegerMap, .need = kRequired, .lower = 0.0, .upper = kMaxInt},
};
constexpr std::string_view kVariantsPath = "/extensions/KHR_materials_variants/variants";
constexpr Property kVariantMapping[] = {
    index("material", "materials", kRequired),
    {.name = "variants", .kind = Kind::kIndices, .need = kRequired, .lower = 0.0, .upper = kMaxInt, .refers_to = kVariantsPath},
};
constexpr Property kVariantMappings[] = {objects("mappings", kVariantMapping, kRequired)};
constexpr Property kSplatting[] = {string("kernel"), string("colorSpace"), string("projection"), string("sortingMethod")};
constexpr Property kPrimitiveExtensions[] = {
    object("KHR_draco_mesh_compression", kDraco),
    object("KHR_gaussian_splatting", kSplatting),
    object("KHR_materials_variants", kVariantMappings),
};
constexpr Property kPrimitive[] = {
    object("extensions", kPrimitiveExtensions),
    index_map("attributes", Kind::kIndexMap, kRequired),
    index("indices", "accessors"),
    index("material", "materials"),
    integer("mode", 0, 6),
    index_map("targets", Kind::kIndexMaps, kOptional),
};
constexpr Property kMesh[] = {string("name"), objects("primitives", kPrimitive, kRequired), numbers("weights", 0)};
constexpr Property kSkin[] = {
    string("name"),
    indices("joints", "nodes", kRequired),
    index("inverseBindMatrices", "accessors"),
};

constexpr Property kImage[] = {string("name"), string("uri"), index("bufferView", "bufferViews")};
constexpr Property kWebpTexture[] = {index("source", "images", kRequired)};
constexpr Property kImageFormats[] = {object("EXT_texture_webp", kWebpTexture)};
constexpr Property kTexture[] = {
    string("name"),
    index("sampler", "samplers"),
    index("source", "images"),
    object("extensions", kImageFormats),
};
constexpr double kFirstFilter = 9728, kLastFilter = 9987, kFirstWrap = 10497, kLastWrap = 33648;
constexpr Property kSampler[] = {
    integer("magFilter", kFirstFilter, kLastFilter),
    integer("minFilter", kFirstFilter, kLastFilter),
    integer("wrapS", kFirstWrap, kLastWrap),
    integer("wrapT", kFirstWrap, kLastWrap),
};

constexpr Property kTextureTransform[] = {
    numbers("offset", 2),
    number("rotation", -FLT_MAX, FLT_MAX),
    numbers("scale", 2),
    integer("texCoord", 0, kMaxInt),
};
constexpr Property kTextureExtensions[] = {object("KHR_texture_transform", kTextureTransform)};
constexpr Property kTextureIndex = index("index", "textures", kRequired), kTexCoord = integer("texCoord", 0, kMaxInt),
                   kTextureExtras = object("extensions", kTextureExtensions);
constexpr Property kTextureInfo[] = {kTextureIndex, kTexCoord, kTextureExtras};
constexpr Property kNormalTexture[] = {kTextureIndex, kTexCoord, kTextureExtras, number("scale", -1e6, 1e6)};
constexpr Property kOcclusionTexture[] = {kTextureIndex, kTexCoord, kTextureExtras, number("strength", 0.0, kOne)};
constexpr Property kMetallicRoughness[] = {
    numbers("baseColorFactor", 4, 0.0, kOne),
    object("baseColorTexture", kTextureInfo),
    number("metallicFactor", 0.0, kOne),
    number("roughnessFactor", 0.0, kOne),
    object("metallicRoughnessTexture", kTextureInfo),
};
constexpr Property kEmissiveStrength[] = {number("emissiveStrength", 0.0, 1e12)};
constexpr Property kIor[] = {number("ior", 0.0, 1000.0)};
constexpr Property kTransmission[] = {number("transmissionFactor", 0.0, kOne), object("transmissionTexture", kTextureInfo)};
constexpr Property kSpecular[] = {
    number("specularFactor", 0.0, kOne),
    object("specularTexture", kTextureInfo),
    numbers("specularColorFactor", 3, 0.0, 1e6),
    object("specularColorTexture", kTextureInfo),
};
constexpr Property kClearcoat[] = {
    number("clearcoatFactor", 0.0, kOne),
    object("clearcoatTexture", kTextureInfo),
    number("clearcoatRoughnessFactor", 0.0, kOne),
    object("clearcoatRoughnessTexture", kTextureInfo),
    object("clearcoatNormalTexture", kNormalTexture),
};
constexpr Property kVolume[] = {
    number("thicknessFactor", 0.0, FLT_MAX),
    object("thicknessTexture", kTextureInfo),
    number("attenuationDistance", 0.0, DBL_MAX),  // exporters write huge numbers for "no attenuation"
    numbers("attenuationColor", 3, 0.0, kOne),
};
constexpr Property kSheen[] = {
    numbers("sheenColorFactor", 3, 0.0, kOne),
    object("sheenColorTexture", kTextureInfo),
    number("sheenRoughnessFactor", 0.0, kOne),
    object("sheenRoughnessTexture", kTextureInfo),
};
constexpr Property kAnisotropy[] = {
    number("anisotropyStrength", 0.0, kOne),
    number("anisotropyRotation", -1e6, 1e6),
    object("anisotropyTexture", kTextureInfo),
};
constexpr Property kIridescence[] = {
    number("iridescenceFactor", 0.0, kOne),          object("iridescenceTexture", kTextureInfo),
    number("iridescenceIor", 1.0, 1000.0),           number("iridescenceThicknessMinimum", 0.0, 1e6),
    number("iridescenceThicknessMaximum", 0.0, 1e6), object("iridescenceThicknessTexture", kTextureInfo),
};
constexpr Property kDiffuseTransmission[] = {
    number("diffuseTransmissionFactor", 0.0, kOne),
    object("diffuseTransmissionTexture", kTextureInfo),
    numbers("diffuseTransmissionColorFactor", 3, 0.0, kOne),
    object("diffuseTransmissionColorTexture", kTextureInfo),
};
constexpr Property kDispersion[] = {number("dispersion", 0.0, 1e3)};
constexpr Property kSpecularGlossiness[] = {
    numbers("diffuseFactor", 4, 0.0, kOne),
    object("diffuseTexture", kTextureInfo),
    numbers("specularFactor", 3, 0.0, kOne),
    number("glossinessFactor", 0.0, kOne),
    object("specularGlossinessTexture", kTextureInfo),
};
constexpr Property kMaterialExtensions[] = {
    object("KHR_materials_volume", kVolume),
    object("KHR_materials_sheen", kSheen),
    object("KHR_materials_anisotropy", kAnisotropy),
    object("KHR_materials_iridescence", kIridescence),
    object("KHR_materials_diffuse_transmission", kDiffuseTransmission),
    object("KHR_materials_dispersion", kDispersion),
    object("KHR_materials_pbrSpecularGlossiness", kSpecularGlossiness),
    object("KHR_materials_clearcoat", kClearcoat),
    object("KHR_materials_specular", kSpecular),
    object("KHR_materials_unlit", {}),
    object("KHR_materials_emissive_strength", kEmissiveStrength),
    object("KHR_materials_ior", kIor),
    object("KHR_materials_transmission", kTransmission),
};
constexpr Property kMaterial[] = {
    string("name"),
    object("pbrMetallicRoughness", kMetallicRoughness),
    object("normalTexture", kNormalTexture),
    object("occlusionTexture", kOcclusionTexture),
    object("emissiveTexture", kTextureInfo),
    numbers("emissiveFactor", 3, 0.0, kOne),
    string("alphaMode", kOptional, "|OPAQUE|MASK|BLEND|"),
    number("alphaCutoff", 0.0, FLT_MAX),
    boolean("doubleSided"),
    object("extensions", kMaterialExtensions),
};

constexpr Property kPerspective[] = {
    number("aspectRatio", kPositive, 1e6),
    number("yfov", kPositive, 3.14, kRequired),
    number("zfar", kPositive, FLT_MAX),
    number("znear", 0.0, FLT_MAX, kRequired),
};
constexpr Property kOrthographic[] = {
    number("xmag", -FLT_MAX, FLT_MAX, kRequired),
    number("ymag", -FLT_MAX, FLT_MAX, kRequired),
    number("zfar", 0.0, FLT_MAX, kRequired),
    number("znear", -FLT_MAX, FLT_MAX, kRequired),
};
constexpr Property kCameraExtras[] = {
    number("shift_x", -100.0, 100.0, kIfKindMatches),
    number("shift_y", -100.0, 100.0, kIfKindMatches),
};
constexpr Property kCamera[] = {
    string("name"),
    string("type", kRequired, "|perspective|orthographic|"),
    object("perspective", kPerspective),
    object("orthographic", kOrthographic),
    object("extras", kCameraExtras, kIfKindMatches),
};

constexpr Property kLightExtras[] = {
    number("radius", 0.0, 1e12, kIfKindMatches),
    number("angle", 0.0, kPi, kIfKindMatches),
    number("blend", 0.0, 1.0, kIfKindMatches),
};
constexpr Property kSpot[] = {number("innerConeAngle", 0.0, kHalfPi), number("outerConeAngle", 0.0, kHalfPi + 1e-6)};
constexpr Property kLight[] = {
    string("name"),
    string("type", kRequired, "|directional|point|spot|"),
    numbers("color", 3, 0.0, 1e6),
    number("intensity", 0.0, 1e12),
    number("range", kPositive, FLT_MAX),
    object("spot", kSpot),
    object("extras", kLightExtras, kIfKindMatches),
};
constexpr Property kLights[] = {objects("lights", kLight, kRequired)};
constexpr Property kVariant[] = {string("name", kRequired)};
constexpr Property kVariants[] = {objects("variants", kVariant, kRequired)};
constexpr Property kProfile[] = {
    string("name"),
    string("uri"),
    index("bufferView", "bufferViews"),
    string("mimeType"),
};
constexpr Property kProfiles[] = {objects("lights", kProfile, kRequired)};
constexpr Property kImageLight[] = {
    numbers("rotation", 4),
    number("intensity", 0.0, 1e12),
    {.name = "specularImages",
     .kind = Kind::kIndexLists,
     .need = kRequired,
     .lower = 0.0,
     .upper = kMaxInt,
     .length = 6,
     .refers_to = "images"},
};
constexpr Property kImageLights[] = {objects("lights", kImageLight, kRequired)};
constexpr Property kRootExtensions[] = {
    object("EXT_lights_ies", kProfiles),
    object("EXT_lights_image_based", kImageLights),
    object("KHR_lights_punctual", kLights),
    object("KHR_materials_variants", kVariants),
};
constexpr std::string_view kProfilesPath = "/extensions/EXT_lights_ies/lights";
constexpr std::string_view kImageLightsPath = "/extensions/EXT_lights_image_based/lights";
constexpr std::string_view kLightsPath = "/extensions/KHR_lights_punctual/lights";

constexpr Property kNodeLight[] = {index("light", kLightsPath, kRequired)};
constexpr Property kNodeProfile[] = {
    index("light", kProfilesPath, kRequired),
    number("multiplier", 0.0, 1e12),
    numbers("color", 3, 0.0, kOne),
};
constexpr Property kInstancing[] = {index_map("attributes", Kind::kIndexMap, kRequired)};
constexpr Property kNodeVisibility[] = {boolean("visible")};
constexpr Property kNodeExtensions[] = {
    object("EXT_lights_ies", kNodeProfile),
    object("EXT_mesh_gpu_instancing", kInstancing),
    object("KHR_lights_punctual", kNodeLight),
    object("KHR_node_visibility", kNodeVisibility),
};
constexpr Property kNodeExtras[] = {flag("visible_to_camera"), flag("casts_shadow")};
constexpr Property kNode[] = {
    string("name"),
    indices("children", "nodes"),
    index("mesh", "meshes"),
    index("skin", "skins"),
    index("camera", "cameras"),
    numbers("matrix", 16),
    numbers("rotation", 4),
    numbers("scale", 3),
    numbers("translation", 3),
    numbers("weights", 0),
    object("extensions", kNodeExtensions),
    object("extras", kNodeExtras, kIfKindMatches),
};
constexpr Property kSceneImageLight[] = {index("light", kImageLightsPath, kRequired)};
constexpr Property kSceneExtensions[] = {object("EXT_lights_image_based", kSceneImageLight)};
constexpr Property kScene[] = {string("name"), indices("nodes", "nodes"), object("extensions", kSceneExtensions)};

constexpr Property kTarget[] = {index("node", "nodes"), string("path", kRequired)};
constexpr Property kChannel[] = {integer("sampler", 0, kMaxInt, kRequired), object("target", kTarget, kRequired)};
constexpr Property kAnimationSampler[] = {
    index("input", "accessors", kRequired),
    index("output", "accessors", kRequired),
    string("interpolation", kOptional, "|LINEAR|STEP|CUBICSPLINE|"),
};
constexpr Property kAnimation[] = {
    string("name"),
    objects("channels", kChannel, kRequired),
    objects("samplers", kAnimationSampler, kRequired),
};

constexpr Property kAsset[] = {string("version", kRequired), string("minVersion"), string("generator")};
constexpr Property kRoot[] = {
    object("asset", kAsset, kRequired),
    {.name = "extensionsUsed", .kind = Kind::kStrings},
    {.name = "extensionsRequired", .kind = Kind::kStrings},
    index("scene", "scenes"),
    objects("accessors", kAccessor),
    objects("animations", kAnimation),
    objects("buffers", kBuffer),
    objects("bufferViews", kBufferView),
    objects("cameras", kCamera),
    objects("images", kImage),
    objects("materials", kMaterial),
    objects("meshes", kMesh),
    objects("nodes", kNode),
    objects("samplers", kSampler),
    objects("scenes", kScene),
    objects("skins", kSkin),
    objects("textures", kTexture),
    object("extensions", kRootExtensions),
};

}  // namespace lippmann::gltf::schema
