// Reads glTF 2.0: JSON with separate files (.gltf), or a single binary file (.glb).
//
// Supported contents:
// - the node hierarchy of the default scene, and its cameras,
// - one of the file's animations,
// - triangle meshes with skins and morph targets,
// - metallic-roughness materials with all their textures (PNG, JPEG, WebP; also BMP, TIFF, GIF and TGA),
// - the extensions KHR_lights_punctual, EXT_lights_ies, EXT_lights_image_based, KHR_node_visibility, KHR_materials_unlit,
//   _emissive_strength, _ior, _transmission, _volume, _dispersion, _diffuse_transmission, _specular, _clearcoat, _sheen,
//   _anisotropy, _iridescence, _pbrSpecularGlossiness, _variants, KHR_texture_transform, EXT_texture_webp,
//   KHR_mesh_quantization, KHR_draco_mesh_compression, EXT_meshopt_compression, EXT_mesh_gpu_instancing.
//
// Each kind of unsupported content causes one warning. An unsupported extension that the file requires is an Error. The reader
// adds no default lights.
//
// The reader does not trust the file. It checks every index, count and byte range before use. It allocates memory in proportion
// to the actual data and within GltfLimits. It opens no file outside the scene's folder and the asset root.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann {

/// Frame rate of animations whose keys fit no other rate. glTF itself has no frame rate.
inline constexpr double kGltfFramesPerSecond = 30.0;

struct GltfLimits {
  std::uint64_t file_bytes = 0xffff'ffff;  ///< size of each file; the default is the largest length that a .glb can state
  std::uint64_t json_values = 20'000'000;  ///< number of JSON values; this limit corresponds to about 2 GB of parsed JSON
  std::uint64_t json_objects = 2'000'000;
  int json_depth = 64;  ///< nesting depth of the JSON; glTF itself needs 9
  std::uint64_t unpacked_bytes = 8'000'000'000;
  int texture_side = 16384;
  int frames = 1'000'000;
};

/// Loads a file. Frame f is at the time f / options.frames_per_second. There are as many frames as fit into the animation
/// without repeating the first one. If options.frames_per_second is 0, the rate is the first of 30, 24, 25 and 60 at which
/// every key falls on a frame, or 30 if there is none. Ignores options.camera_path. Throws Error naming the file and the
/// element ("Box.glb: accessors[3]: ...").
Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options, const Context& context,
                const GltfLimits& limits = {});

/// Same as load_gltf(), for the contents of a file. `path` names the file in messages, and its folder holds the files that the
/// scene refers to.
Scene parse_gltf(std::vector<std::byte> contents, const std::filesystem::path& path, const LoadOptions& options,
                 const Context& context, const GltfLimits& limits = {});

/// Returns whether a file has meshes and all of them are splats. Returns false for unreadable files.
bool is_gltf_splat_file(const std::filesystem::path& path);

}  // namespace lippmann
