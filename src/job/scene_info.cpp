#include "job/scene_info.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <variant>

#include "core/printable.hpp"
#include "job/placed_job.hpp"
#include "job/report.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "optics/optics_json.hpp"
#include "scene/deform.hpp"
#include "stage/depth_budget.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSampledFrames = 32;

struct CountShape {
  SceneInfo& info;
  void operator()(const Mesh& mesh) const { ++info.meshes, info.triangles += mesh.triangles.size(); }
  void operator()(const Spheres& spheres) const { info.spheres += spheres.size(); }
  void operator()(const Cylinders& cylinders) const { info.cylinders += cylinders.size(); }
  void operator()(const Planes& planes) const { info.planes += planes.size(); }
  void operator()(const Rings& rings) const { info.rings += rings.size(); }
  void operator()(const Boxes& boxes) const { info.boxes += boxes.size(); }
  void operator()(const Splats& splats) const { info.splats += splats.centers.size(); }
};

/// A shape is counted once for each of its instances.
void count(const Scene& scene, SceneInfo& info) {
  info.nodes = scene.nodes.size();
  info.instances = scene.instances.size();
  info.materials = scene.materials.size();
  info.textures = scene.textures.size();
  info.lights = scene.lights.size();
  info.cameras = scene.cameras.size();
  for (const Instance& instance : scene.instances)
    std::visit(CountShape{info}, scene.shapes[static_cast<std::size_t>(instance.shape)]);
  const std::vector<bool> moves = moving_instances(scene);
  info.moving_instances = static_cast<std::size_t>(std::count(moves.begin(), moves.end(), true));
}

Bounds3f bounds_over_animation(const Scene& scene) {
  Bounds3f bounds;
  const int step = std::max(1, scene.timeline.frame_count / kSampledFrames);
  for (int frame = 0; frame < scene.timeline.frame_count; frame += step)
    bounds.add(finite_bounds(scene, evaluate(scene, scene.timeline.time(frame))));
  return bounds;
}

/// Returns the position in the coordinates of the file.
Json place_json(const SceneInfo& info, Vec3f p) {
  const Vec3d place = info.origin + Vec3d(p);
  return {place.x, place.y, place.z};
}

Json bounds_json(const SceneInfo& info) {
  if (info.bounds.empty()) return nullptr;
  return {{"lower", place_json(info, info.bounds.lower)}, {"upper", place_json(info, info.bounds.upper)}};
}

/// Returns "(1, 2, 3)", with 12 digits instead of 6 if the scene was moved to another origin.
std::string place_text(const SceneInfo& info, Vec3f p) {
  const Vec3d place = info.origin + Vec3d(p);
  const int digits = info.origin == Vec3d(0.0) ? 6 : 12;
  return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", place.x, digits, place.y, digits, place.z, digits);
}

/// Returns, for example, "shown: Walk (1); others: Survey (0), Run (2)".
std::string list_animations(const SceneInfo& info) {
  const auto shown_one = static_cast<std::size_t>(info.animation);
  const auto label = [&](std::size_t i) { return fmt::format("{} ({})", printable(info.animations[i]), i); };
  std::string text = fmt::format("shown: {}; others:", label(shown_one));
  for (std::size_t i = 0; i < info.animations.size(); ++i)
    if (i != shown_one) text += ' ' + label(i) + ',';
  text.pop_back();
  return text;
}

/// Returns, for example, "Beach (0), Street (1)".
std::string list_variants(const SceneInfo& info) {
  std::string text;
  for (std::size_t i = 0; i < info.variants.size(); ++i)
    text += fmt::format("{}{} ({})", i == 0 ? "" : ", ", printable(info.variants[i]), i);
  return text;
}

/// States whether all animation keys fall on frames; empty for a file without animations.
std::string describe_keys(const SceneInfo& info) {
  if (info.animations.empty()) return "";
  return info.keys_on_frames ? "; all keys of the file lie on frames"
                             : "; some keys of the file lie between frames (see --fps)";
}

/// Returns, for example, "48 frames at 24 fps, 2.0 s; 3 of 5 instances move", or "none: a still scene".
std::string describe_animation(const SceneInfo& info) {
  if (info.frames == 1 && info.animations.empty() && info.moving_instances == 0) return "none: a still scene";
  return fmt::format("{} frame{} at {:g} fps, {:.1f} s{}; {} of {} instance{} move", info.frames, info.frames == 1 ? "" : "s",
                     info.frames_per_second, info.frames / info.frames_per_second, describe_keys(info), info.moving_instances,
                     info.instances, info.instances == 1 ? "" : "s");
}

/// Lists all counts above 0, as in "3 meshes, 1 light".
std::string list_counts(std::initializer_list<std::pair<std::size_t, std::string_view>> counts) {
  std::string text;
  for (const auto& [number, name] : counts) {
    if (number == 0) continue;
    const std::string plural = number == 1 ? "" : name == "mesh" || name == "box" ? "es" : "s";
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", number, name, plural);
  }
  return text.empty() ? "nothing" : text;
}

}  // namespace

SceneInfo describe_scene(const ResolvedJob& job, const Context& context) {
  SceneInfo info;
  Context collecting;
  collecting.threads = context.threads;
  collecting.warn = [&](std::string_view text) { info.warnings.emplace_back(text); };
  JobScene loaded = load_scene_of(job, collecting);
  const Scene& scene = loaded.scene;
  info.notes = std::move(loaded.notes);
  info.name = scene.name;
  info.animations = scene.animation_names, info.animation = scene.animation;
  info.variants = scene.variant_names;
  info.frames = scene.timeline.frame_count;
  info.frames_per_second = scene.timeline.frames_per_second;
  info.keys_on_frames = keys_fall_on_frames(scene.timeline, info.frames_per_second);
  count(scene, info);
  info.origin = scene.origin;
  info.bounds = bounds_over_animation(scene);
  PlacedJob placed_job = place(job, scene);
  info.array = std::move(placed_job.array);
  const PlacedOptics& placed = placed_job.placed;
  info.optics = placed.optics;
  info.units_per_mm = placed.units_per_mm, info.depth_scale = placed.depth_scale;
  info.array_center = world_from_display(info.array, info.units_per_mm, evaluate(scene, scene.timeline.time(0))).translation;
  return info;
}

Json to_json(const SceneInfo& info) {
  const double distance = info.array.viewing_distance;
  return {{"name", info.name},
          {"nodes", info.nodes},
          {"instances", info.instances},
          {"moving_instances", info.moving_instances},
          {"meshes", info.meshes},
          {"triangles", info.triangles},
          {"spheres", info.spheres},
          {"cylinders", info.cylinders},
          {"planes", info.planes},
          {"rings", info.rings},
          {"boxes", info.boxes},
          {"splats", info.splats},
          {"materials", info.materials},
          {"textures", info.textures},
          {"lights", info.lights},
          {"cameras", info.cameras},
          {"camera_names", info.notes.camera_names},
          {"light", info.notes.light},
          {"animations", info.animations},
          {"animation", info.animation < 0 ? Json(nullptr) : Json(info.animation)},
          {"variants", info.variants},
          {"frames", info.frames},
          {"frames_per_second", info.frames_per_second},
          {"seconds", info.frames / info.frames_per_second},
          {"keys_on_frames", info.keys_on_frames},
          {"bounds", bounds_json(info)},
          {"array",
           {{"fitted", info.array.how},
            {"center", place_json(info, info.array_center)},
            {"height", info.array.plane_height},
            {"viewing_distance", std::isfinite(distance) ? Json(distance) : Json(nullptr)},
            {"units_per_mm", info.units_per_mm}}},
          {"optics", optics_json(info.optics)},
          {"depth", depth_json(shown_depth(info.array, info.units_per_mm, info.depth_scale, info.optics), info.depth_scale,
                               info.optics)},
          {"warnings", info.warnings}};
}

std::string to_text(const SceneInfo& info) {
  std::string text = printable_line(info.name) + '\n';
  const auto line = [&](std::string_view name, const std::string& value) {
    text += fmt::format("  {:<10} {}\n", name, printable_line(value));
  };
  line("shapes", list_counts({{info.meshes, "mesh"},
                              {info.triangles, "triangle"},
                              {info.spheres, "sphere"},
                              {info.cylinders, "cylinder"},
                              {info.planes, "plane"},
                              {info.rings, "ring"},
                              {info.boxes, "box"},
                              {info.splats, "splat"}}));
  line("others", list_counts({{info.instances, "instance"},
                              {info.materials, "material"},
                              {info.textures, "texture"},
                              {info.lights, "light"},
                              {info.cameras, "camera"}}));
  if (info.cameras > 1) line("cameras", list_cameras(info.notes.camera_names) + "; --camera chooses");
  if (!info.variants.empty()) line("variants", list_variants(info) + "; --variant chooses");
  line("light", info.notes.light);
  line("animation", describe_animation(info));
  if (info.animations.size() > 1) line("", list_animations(info));
  if (!info.bounds.empty())
    line("bounds", fmt::format("{} to {}", place_text(info, info.bounds.lower), place_text(info, info.bounds.upper)));
  line("array", info.array.how);
  line("", fmt::format("Its centre is at {}.", place_text(info, info.array_center)));
  line("panel", fmt::format("{}x{} pixels of {:.4g} mm; 1 mm = {:.4g} scene units", info.optics.panel.width,
                            info.optics.panel.height, info.optics.panel.pixel_pitch_mm, info.units_per_mm));
  line("viewing", fmt::format("zone {:.1f} degrees", degrees(viewing_zone(info.optics))));
  line("depth", depth_budget_sentence(shown_depth(info.array, info.units_per_mm, info.depth_scale, info.optics), info.optics,
                                      info.depth_scale));
  for (const std::string& warning : info.warnings) line("warning", warning);
  return text;
}

}  // namespace lippmann
