#include "lippmann/scene/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/file_content.hpp"
#include "core/regular_file.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/builtin.hpp"
#include "lippmann/scene/origin.hpp"
#include "scene/gltf.hpp"
#include "scene/move_origin.hpp"
#include "scene/nff.hpp"
#include "scene/obj.hpp"
#include "scene/ply.hpp"
#include "scene/tachyon.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

Scene at_rate(Scene scene, const LoadOptions& options) {
  if (options.frames_per_second > 0.0) scene.timeline.frames_per_second = options.frames_per_second;
  return scene;
}

Scene load_dat(const fs::path& path, const LoadOptions& options, const Context& context, const Vec3d& origin) {
  const double fps = options.frames_per_second > 0.0 ? options.frames_per_second : kTachyonFramesPerSecond;
  return load_tachyon(path, options.camera_path, context, fps, options.asset_root, origin);
}

/// Ignores the origin because load_gltf() moves the scene's origin itself.
Scene load_gltf_file(const fs::path& path, const LoadOptions& options, const Context& context, const Vec3d&) {
  return load_gltf(path, options, context);
}

Scene load_nff_file(const fs::path& path, const LoadOptions& options, const Context& context, const Vec3d& origin) {
  return at_rate(load_nff(path, context, origin), options);
}

Scene load_obj_file(const fs::path& path, const LoadOptions& options, const Context& context, const Vec3d& origin) {
  return at_rate(load_obj(path, context, options.asset_root, options.texture_bytes, origin), options);
}

Scene load_ply_file(const fs::path& path, const LoadOptions& options, const Context& context, const Vec3d& origin) {
  return at_rate(load_ply(path, context, {{{}, options.asset_root}, options.texture_bytes, origin, options.point_size}),
                 options);
}

bool always_false(const fs::path&) { return false; }

/// Formats with the same loader must be adjacent in the table.
struct Format {
  std::string_view extension;
  bool takes_camera_path;
  /// The format supports several animations and material variants.
  bool has_animations;
  /// A scene without surfaces is valid because its background is visible.
  bool may_be_empty;
  bool is_physical;
  bool may_be_points;
  std::string_view kind;
  bool (*is_splat_file)(const fs::path&);
  Scene (*load)(const fs::path&, const LoadOptions&, const Context&, const Vec3d& origin);
};

constexpr std::string_view kGlb = "a binary glTF scene (.glb)";
constexpr Format kFormats[] = {
    {".dat", true, false, true, false, false, {}, always_false, load_dat},
    {".glb", false, true, false, true, false, kGlb, is_gltf_splat_file, load_gltf_file},
    {".gltf", false, true, false, true, false, kGlb, is_gltf_splat_file, load_gltf_file},
    {".nff", false, false, false, false, false, {}, always_false, load_nff_file},
    {".obj", false, false, false, true, false, {}, always_false, load_obj_file},
    {".ply", false, false, false, true, true, "a PLY file", is_ply_splat_file, load_ply_file},
};

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string accepted_names() {
  std::string names;
  for (const BuiltinScene& scene : builtin_scenes()) names += fmt::format("{}, ", scene.name);
  names += "or a file";
  for (const Format& format : kFormats) names += fmt::format(" {}", format.extension);
  return names;
}

/// Returns text for an error message that suggests the built-in scene with the most similar name. Returns an empty text if no
/// name is similar, or if `path` has a folder or an extension.
std::string suggested_builtin(const fs::path& path) {
  if (path.has_parent_path() || path.has_extension()) return {};
  std::vector<std::string_view> names;
  for (const BuiltinScene& scene : builtin_scenes()) names.push_back(scene.name);
  return did_you_mean(path.string(), names);
}

/// Throws Error for an unknown format. If Blender can read the format, the message explains how to convert the file.
[[noreturn]] void refuse_format(const fs::path& path) {
  constexpr std::string_view kBlenderFormats[] = {".usd", ".usda", ".usdc", ".usdz", ".abc", ".fbx", ".dae", ".stl"};
  const std::string extension = lower_extension(path);
  if (extension == ".blend")
    throw Error(path.string(), "is a Blender file",
                "a render with the Blender add-on (docs/guide/blender.md), or a .glb that it exports");
  if (std::find(std::begin(kBlenderFormats), std::end(kBlenderFormats), extension) != std::end(kBlenderFormats))
    throw Error(path.string(), "is a scene format that Blender reads",
                "a .glb converted with Blender and to_glb.py (docs/guide/scenes.md, \"Other formats\")");
  throw Error(path.string(), "is not a known scene format", accepted_names());
}

void require_readable_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw Error(path.string(), "there is no such file" + suggested_builtin(path), accepted_names());
  if (fs::is_directory(status)) throw Error(path.string(), "is a folder", accepted_names());
}

/// Throws Error if the content of a file does not match its extension.
void require_scene_content(const fs::path& path, std::string_view own_kind) {
  constexpr std::size_t kLooked = 512;
  if (!RegularFile(path).problem().empty()) return;
  const std::string begin = read_file_begin(path, kLooked);
  const FileContent content = describe_content(std::as_bytes(std::span(begin)));
  if (!content.advice.empty()) throw Error(path.string(), "is " + content.what, content.advice);
  const bool is_text = content.what.starts_with("text"), is_unknown = content.what.starts_with("binary data");
  if (!is_text && !is_unknown && content.what != own_kind)
    throw Error(path.string(), "is " + content.what, fmt::format("a scene in the format of {}", lower_extension(path)));
}

void require_folder(const fs::path& asset_root) {
  std::error_code failure;
  if (!asset_root.empty() && !fs::is_directory(asset_root, failure))
    throw usage_error("asset-root", fmt::format("{} is not a folder", asset_root.string()), "the folder of a scene's textures");
}

/// Throws Error for a scene without surfaces. Visible lamps count as surfaces.
void require_surfaces(const Scene& scene, const fs::path& path) {
  const auto has_faces = [&](const Instance& instance) {
    const Mesh* mesh = std::get_if<Mesh>(&scene.shapes[static_cast<std::size_t>(instance.shape)]);
    return !mesh || !mesh->triangles.empty();
  };
  const auto is_seen = [](const Light& light) { return light.visible_radius > 0.0f; };
  if (std::any_of(scene.instances.begin(), scene.instances.end(), has_faces)) return;
  if (std::any_of(scene.lights.begin(), scene.lights.end(), is_seen)) return;
  throw Error(path.string(), "has no surfaces to show", "a scene with faces or solid shapes; points and lines are not shown");
}

/// If the scene is far from its origin, loads it again with a new origin, which the loader subtracts before it rounds positions
/// to floats.
Scene load_near_origin(const Format& format, const fs::path& path, const LoadOptions& options, const Context& context) {
  Scene scene = format.load(path, options, context, Vec3d(0.0));
  const std::optional<Vec3d> origin = distant_origin(scene);
  if (!origin) return scene;
  Context without_warnings;  // the first load has already reported all warnings
  without_warnings.threads = context.threads;
  scene = {};
  scene = format.load(path, options, without_warnings, *origin);
  if (scene.origin == Vec3d(0.0)) move_origin(scene, *origin);  // this loader does not subtract origins
  return scene;
}

const Format* find_format(const fs::path& path) {
  const std::string extension = lower_extension(path);
  const auto* format = std::find_if(std::begin(kFormats), std::end(kFormats),
                                    [&](const Format& candidate) { return candidate.extension == extension; });
  return format == std::end(kFormats) ? nullptr : format;
}

Scene load_file(const fs::path& path, const LoadOptions& options, const Context& context) {
  const Format* format = find_format(path);
  require_readable_file(path);
  require_folder(options.asset_root);
  if (!format) refuse_format(path);
  if (options.camera_path && !format->takes_camera_path)
    throw usage_error("camera-path", fmt::format("{} has its own cameras", path.string()), "a Tachyon .dat scene");
  if (!options.animation.empty() && !format->has_animations)
    throw usage_error("animation", fmt::format("{} has no animations to choose from", path.string()), "a glTF scene");
  if (!options.variant.empty() && !format->has_animations)
    throw usage_error("variant", fmt::format("{} has no material variants", path.string()), "a glTF scene");
  if (options.point_size > 0.0 && !format->may_be_points)
    throw usage_error("points", fmt::format("{} is not a point cloud", path.string()), "a PLY file without faces");
  require_scene_content(path, format->kind);
  Scene scene = load_near_origin(*format, path, options, context);
  if (!format->is_physical) scene.kind = SceneKind::kWhitted;
  if (!format->may_be_empty) require_surfaces(scene, path);
  return scene;
}

const BuiltinScene* find_builtin(const std::string& name) {
  for (const BuiltinScene& scene : builtin_scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

/// A different frame rate changes the number of frames but not the speed of the motion.
Scene build(const BuiltinScene& builtin, const LoadOptions& options) {
  if (options.camera_path)
    throw usage_error("camera-path", fmt::format("{} has its own cameras", builtin.name), "a Tachyon .dat scene");
  if (!options.animation.empty())
    throw usage_error("animation", fmt::format("{} has no animations to choose from", builtin.name), "a glTF scene");
  if (!options.variant.empty())
    throw usage_error("variant", fmt::format("{} has no material variants", builtin.name), "a glTF scene");
  Scene scene = builtin.build();
  scene.kind = SceneKind::kWhitted;
  Timeline& timeline = scene.timeline;
  if (options.frames_per_second > 0.0) {
    const double seconds = timeline.frame_count / timeline.frames_per_second;
    timeline.frame_count = std::max(1, static_cast<int>(std::lround(std::min(1e9, seconds * options.frames_per_second))));
    timeline.frames_per_second = options.frames_per_second;
  }
  return scene;
}

}  // namespace

SceneKind scene_kind(const std::string& name) {
  const Format* format = find_builtin(name) ? nullptr : find_format(name);
  if (!format || !format->is_physical) return SceneKind::kWhitted;
  return format->is_splat_file(name) ? SceneKind::kSplats : SceneKind::kPhysical;
}

Scene load_scene(const std::string& name, const LoadOptions& options, const Context& context) {
  const BuiltinScene* builtin = find_builtin(name);
  Scene scene = builtin ? build(*builtin, options) : load_file(name, options, context);
  validate(scene, name);
  return scene;
}

}  // namespace lippmann
