// Reads glTF 2.0, the Khronos Group's exchange format, as JSON with separate files (.gltf) or as one binary (.glb).
//
// Supported: the default scene's node hierarchy; one of the file's animations; triangle meshes with skins and morph targets;
// metallic-roughness materials with all their textures (PNG, JPEG, WebP); cameras; the extensions KHR_lights_punctual,
// EXT_lights_ies, EXT_lights_image_based, KHR_node_visibility, KHR_materials_unlit, _emissive_strength, _ior, _transmission,
// _volume, _dispersion, _diffuse_transmission, _specular, _clearcoat, _sheen, _anisotropy, _iridescence,
// _pbrSpecularGlossiness, _variants, KHR_texture_transform, EXT_texture_webp, KHR_mesh_quantization,
// KHR_draco_mesh_compression, EXT_meshopt_compression, EXT_mesh_gpu_instancing. No default lights are added. Unsupported
// contents (other extensions, further scenes) cause one warning each. A required extension that is not in this list is an
// Error.
//
// The reader does not trust the file: it checks every index, count and byte range before use, allocates memory in proportion to
// the actual data and within GltfLimits, and opens no file outside the scene's folder and the asset root.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann {

inline constexpr double kGltfFramesPerSecond = 30.0;  ///< used if no rate fits the keys; glTF stores seconds, not frames

/// Resource limits of one scene. Exceeding one is an Error.
struct GltfLimits {
  std::uint64_t file_bytes = 0xffff'ffff;        ///< size of each file; the largest 32-bit length of a .glb
  std::uint64_t json_values = 20'000'000;        ///< about 2 GB of parsed JSON at worst
  std::uint64_t json_objects = 2'000'000;        ///< number of nodes, meshes, accessors, ...
  int json_depth = 64;                           ///< glTF itself needs 9
  std::uint64_t unpacked_bytes = 8'000'000'000;  ///< total size of meshes, instances and key frames
  int texture_side = 16384;                      ///< pixels
  int frames = 1'000'000;                        ///< largest number of frames of an animation
};

/// Loads a file. The timeline shows frame f at f / options.frames_per_second and has as many frames as fit the animation's
/// length without repeating the first one, at least one. If options.frames_per_second is 0, the rate is the first of 30, 24, 25
/// and 60 at which every key falls on a frame, or 30 if there is none. Ignores options.camera_path. Throws Error naming the
/// file and the element ("Box.glb: accessors[3]: ...").
Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options, const Context& context,
                const GltfLimits& limits = {});

/// Like load_gltf(), but for the contents of a file. `path` names the file in messages; side files are searched in its folder.
Scene parse_gltf(std::vector<std::byte> contents, const std::filesystem::path& path, const LoadOptions& options,
                 const Context& context, const GltfLimits& limits = {});

/// Returns whether a file has meshes and all of them are splats (KHR_gaussian_splatting). False for unreadable files.
bool is_gltf_splat_file(const std::filesystem::path& path);

}  // namespace lippmann
