// Reads glTF 2.0, the Khronos Group's exchange format, as one JSON file with others beside it (.gltf) or as one binary (.glb).
//
// Read: the default scene's node hierarchy; one of the file's animations; triangle meshes, their skins and morph targets;
// metallic-roughness materials with all their textures (PNG, JPEG, WebP); cameras; the extensions KHR_lights_punctual,
// EXT_lights_ies, EXT_lights_image_based, KHR_node_visibility, KHR_materials_unlit, _emissive_strength, _ior, _transmission,
// _volume, _dispersion, _diffuse_transmission, _specular, _clearcoat, _sheen, _anisotropy, _iridescence,
// _pbrSpecularGlossiness, _variants, KHR_texture_transform, EXT_texture_webp, KHR_mesh_quantization,
// KHR_draco_mesh_compression, EXT_meshopt_compression, EXT_mesh_gpu_instancing. Lights are as in the file: there may be none.
// What else a file holds and this reader leaves out (other extensions, further scenes) is named by one warning; an extension
// that the file requires and that is not in the list above is an Error.
//
// Nothing in a file is trusted: every index, count and byte range is checked before it is used, memory grows with the bytes
// that are really there and never beyond GltfLimits, and no file outside the scene's own folder and the asset root is opened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann {

inline constexpr double kGltfFramesPerSecond = 30.0;  ///< glTF has seconds, not frames; where keys tell no other rate

/// What one scene may ask for; beyond it reading stops with an Error.
struct GltfLimits {
  std::uint64_t file_bytes = 0xffff'ffff;        ///< size of each file: what a .glb's 32-bit length can say
  std::uint64_t json_values = 20'000'000;        ///< about 2 GB of parsed JSON at worst
  std::uint64_t json_objects = 2'000'000;        ///< nodes, meshes, accessors, ...
  int json_depth = 64;                           ///< glTF itself needs 9
  std::uint64_t unpacked_bytes = 8'000'000'000;  ///< meshes, instances and key frames together
  int texture_side = 16384;                      ///< pixels
  int frames = 1'000'000;                        ///< how many the animation may have
};

/// Throws Error naming the file and the element ("Box.glb: accessors[3]: ..."). The timeline shows frame f
/// at f / options.frames_per_second and has as many frames as fit the animation's length (so that it loops), at least one; with
/// frames_per_second 0 at the first of 30, 24, 25 and 60 a second at which every key falls on a frame, else at 30. The options'
/// camera_path is of other formats and not looked at.
Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options, const Context& context,
                const GltfLimits& limits = {});

/// The same of a file's contents; `path` names it in messages, and the files that it refers to lie in its folder.
Scene parse_gltf(std::vector<std::byte> contents, const std::filesystem::path& path, const LoadOptions& options,
                 const Context& context, const GltfLimits& limits = {});

/// Whether all meshes of a file are splats (KHR_gaussian_splatting), and there are some. What cannot be read is none.
bool is_gltf_of_splats(const std::filesystem::path& path);

}  // namespace lippmann
