#include "frames/picture_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/optics/viewing.hpp"
#include "scene/deform.hpp"
#include "scene/splats.hpp"
#include "trace/first_hits.hpp"

namespace lippmann {
namespace {

constexpr int kRaysAcross = 128;
constexpr double kLeastShare = 0.001;
constexpr float kLeastOpacity = 1.0f / 256.0f;

/// Returns optics with a single view, from the viewer's eye through the rectangle of the display.
Optics through_the_frame(const Optics& optics) {
  const Vec2f window = window_size_mm(optics);
  const float across = std::min(window.x, window.y) / static_cast<float>(kRaysAcross);
  Optics view;
  view.panel = {std::max(1, static_cast<int>(std::lround(window.x / across))),
                std::max(1, static_cast<int>(std::lround(window.y / across))), across};
  Optics from_eye = optics;
  from_eye.z_front_mm = kInfinity;
  const float distance = resolved_z_front_mm(from_eye);
  view.model = SingleView{distance, Vec2f(0.0f), static_cast<float>(design_viewer(optics).slope_at_centre.y) * distance};
  view.z_front_mm = resolved_z_front_mm(optics), view.z_back_mm = optics.z_back_mm;
  return view;
}

float largest_alpha(const Scene& scene, const MetallicRoughness& surface, const Shape& shape) {
  float largest = surface.base_color.w;
  if (const auto* mesh = std::get_if<Mesh>(&shape); mesh && !mesh->alphas.empty())
    largest *= *std::max_element(mesh->alphas.begin(), mesh->alphas.end());
  if (const int texture = surface.base_color_map.texture; texture >= 0) {
    const std::vector<std::uint8_t>& rgba = scene.textures[static_cast<std::size_t>(texture)].rgba;
    std::uint8_t most = 0;
    for (std::size_t i = 3; i < rgba.size(); i += 4) most = std::max(most, rgba[i]);
    largest *= static_cast<float>(most) / 255.0f;
  }
  return largest;
}

bool is_transparent(const Scene& scene, const Instance& instance) {
  const Shape& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
  if (const auto* splats = std::get_if<Splats>(&shape))
    return std::all_of(splats->opacities.begin(), splats->opacities.end(), [](float o) { return reach_of_splat(o) == 0.0f; });
  const auto* m = std::get_if<MetallicRoughness>(&scene.materials[static_cast<std::size_t>(instance.material)].surface);
  return m && (m->blend || m->alpha_cutoff > 0.0f) &&
         largest_alpha(scene, *m, shape) < std::max(kLeastOpacity, m->alpha_cutoff);
}

bool all_transparent(const Scene& scene) {
  return std::all_of(scene.instances.begin(), scene.instances.end(),
                     [&](const Instance& instance) { return is_transparent(scene, instance); });
}

bool has_area(const Mesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
    const auto& [a, b, c] = triangle;
    return glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]) != Vec3f(0.0f);
  });
}

bool any_area(const Scene& scene) {
  return std::any_of(scene.instances.begin(), scene.instances.end(), [&](const Instance& instance) {
    const auto* mesh = std::get_if<Mesh>(&scene.shapes[static_cast<std::size_t>(instance.shape)]);
    return !mesh || has_area(*mesh);
  });
}

bool all_behind(const Stage& stage, int frame) {
  const Moment moment = stage.moment_at(frame);
  const Bounds3f bounds = finite_bounds(stage.scene, moment.resolved, inverse(moment.world_from_display));
  return !bounds.empty() && bounds.lower.z > resolved_z_front_mm(stage.placed.optics);
}

std::string why_nothing_is_met(const Stage& stage, int frame) {
  const Scene& scene = stage.scene;
  if (scene.instances.empty()) return "the scene has no surfaces";
  if (!any_area(scene)) return "all triangles of the scene have area 0";
  if (all_transparent(scene))
    return "everything in the scene is transparent: its alpha is 0, or below the cutoff of its material";
  if (all_behind(stage, frame)) return "everything lies behind the viewer";
  if (stage.array.origin == FittedArray::Origin::kBounds) return "its parts are too small or too far apart to be seen";
  return "nothing lies within the view; a view that is fitted to a node shows it";
}

bool gives_light(const Material& material) {
  if (const auto* phong = std::get_if<PhongSurface>(&material.surface))
    return phong->emission != Vec3f(0.0f) || phong->ambient != 0.0f;
  const auto& surface = std::get<MetallicRoughness>(material.surface);
  return surface.unlit || surface.emissive != Vec3f(0.0f);
}

bool has_light(const Scene& scene) {
  const Background& around = scene.background;
  if (around.map) {
    const std::vector<float>& texels = around.map->radiance.data;
    if (around.map->strength > 0.0f && std::any_of(texels.begin(), texels.end(), [](float v) { return v != 0.0f; }))
      return true;
  } else if (around.horizon != Vec3f(0.0f) || around.zenith != Vec3f(0.0f)) {
    return true;
  }
  return std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.color != Vec3f(0.0f); }) ||
         std::any_of(scene.materials.begin(), scene.materials.end(), gives_light);
}

bool is_uniform(const Image& film) {
  const auto channels = static_cast<std::size_t>(film.channels);
  return std::equal(film.data.begin() + static_cast<std::ptrdiff_t>(std::min(channels, film.data.size())), film.data.end(),
                    film.data.begin());
}

std::string why_uniform(const Scene& scene, const SeenShare& seen, const Image& film) {
  const bool is_black = std::all_of(film.data.begin(), film.data.end(), [](float v) { return v == 0.0f; });
  if (is_black && !has_light(scene)) return "there is no light in the scene";
  if (seen.only_instance >= 0)
    return fmt::format("{} fills the image: the viewer may be inside it or too close",
                       shown(scene.instances[static_cast<std::size_t>(seen.only_instance)].name));
  return is_black ? "no light reaches the visible surfaces" : "all visible surfaces have the same colour and light";
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

}  // namespace

SeenShare look_at_frame(Stage& stage, int frame, const ThreadPool& pool) {
  const Moment moment = stage.moment_at(frame);
  stage.device.update(moment.resolved, pool);
  const Optics view = through_the_frame(stage.placed.optics);
  FrameAovs aovs;
  aovs.want(Aov::kId);
  find_first_hits({stage.device, view, moment.world_from_display}, RayOrder::kViewTiles, nullptr, pool, aovs, kLeastOpacity);
  const std::vector<float>& ids = aovs[Aov::kId].data;
  const std::vector<bool>& is_subject = stage.array.is_subject;
  const auto count = static_cast<double>(ids.size());
  SeenShare seen;
  for (const float id : ids) {
    if (!(id >= 0.0f)) continue;
    seen.anything += 1.0 / count;
    const auto instance = static_cast<std::size_t>(id);
    if (instance < is_subject.size() && is_subject[instance]) seen.subject += 1.0 / count;
  }
  if (std::all_of(ids.begin(), ids.end(), [&](float id) { return id >= 0.0f && id == ids.front(); }))
    seen.only_instance = static_cast<int>(ids.front());
  return seen;
}

std::string doubt_about_picture(const Stage& stage, int frame, const SeenShare& seen, const Image& film) {
  const bool is_fitted = stage.array.origin == FittedArray::Origin::kBounds;
  const double share = is_fitted && !stage.array.is_subject.empty() ? seen.subject : seen.anything;
  const bool is_small = share < kLeastShare && !has_splats(stage.scene);
  if (seen.anything == 0.0 && (is_small || (has_splats(stage.scene) && all_transparent(stage.scene))))
    return fmt::format("frame {} shows nothing of the scene: {}", frame, why_nothing_is_met(stage, frame));
  if (is_small)
    return fmt::format(
        "frame {} shows {} of its subject, which covers {} of the picture; a view that is fitted to a node or zoomed shows "
        "more",
        frame, share > 0.0 ? "next to nothing" : "nothing", percent(share));
  if (std::all_of(film.data.begin(), film.data.end(), [](float v) { return v > 1.0f; }))
    return fmt::format("frame {} is overexposed: all of it is brighter than white; a lower exposure or a tone curve shows more",
                       frame);
  if (is_uniform(film)) return fmt::format("frame {} has a single colour: {}", frame, why_uniform(stage.scene, seen, film));
  return {};
}

}  // namespace lippmann
