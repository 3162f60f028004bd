#include "bench/light_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "bench/hostile_scenes.hpp"
#include "bench/scenes.hpp"
#include "job/param_text.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/builtin.hpp"

namespace lippmann::bench {
namespace {

constexpr int kFrames = 12, kReferenceSamples = 2048, kRowShare = 32, kHostileReferenceSamples = 1024;
constexpr int kQuickFrames = 3, kQuickSamples = 8, kQuickReferenceSamples = 64, kQuickRowShare = 4, kQuickTile = 16;
constexpr std::string_view kQuilt = "-quilt";

struct QuietRow {
  std::string name;
  LightBar bar;
};

const std::vector<QuietRow>& quiet_rows() {
  static const std::vector<QuietRow> all{{"teapot", {0.96, 0.0, 10.0, {}, {}}},    {"room", {0.96, 0.0, 10.0, {}, {}}},
                                         {"small-balls", {0.86, 0.0, {}, {}, {}}}, {"tree", {0.75, -0.5, {}, {}, {}}},
                                         {"room-quilt", {0.90, 0.0, {}, {}, {}}},  {"tree-quilt", {0.60, 0.0, {}, {}, {}}}};
  return all;
}

/// Errors of neighbouring pixels must not be alike, light must not be lost, and time must not be wasted.
constexpr LightBar kHostileBar{-0.05, {}, {}, -3.0, 0.005};

const HostileScene* find_hostile(const std::string& name) {
  for (const HostileScene& scene : hostile_scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

bool is_quilt(const std::string& name) { return name.ends_with(kQuilt); }
std::string scene_of_quilt(const std::string& name) { return name.substr(0, name.size() - kQuilt.size()); }

void check_name(const std::string& name) {
  const std::string scene = is_quilt(name) ? scene_of_quilt(name) : name;
  if (find_hostile(name) || is_builtin_scene(scene) || std::filesystem::exists(scene)) return;
  std::string known;
  for (const QuietRow& row : quiet_rows()) known += row.name + ", ";
  for (const HostileScene& hostile : hostile_scenes()) known += hostile.name + ", ";
  throw usage_error("--scene", fmt::format("there is no row '{}' and no such file", name),
                    known + "another built-in scene or a file, or one of these with " + std::string(kQuilt));
}

LightCase quiet_case(const std::string& name, const std::string& scene, const Request& request) {
  LightCase result;
  result.name = name, result.scene = scene;
  result.params = params_of(scene);
  result.params.sampling.integrator = Integrator::kPath;
  result.reference_spp = kReferenceSamples;
  result.row_share = request.quick ? kQuickRowShare : kRowShare;
  return result;
}

LightCase animation_of(const std::string& name, const Request& request, const Context& context) {
  LightCase result = quiet_case(name, name, request);
  const int wanted = request.frames > 0 ? request.frames : request.quick ? kQuickFrames : kFrames;
  result.count = std::min(wanted, wanted_scene(result.params, context).timeline.frame_count);
  if (request.quick) result.params.optics.lenses = {8, 8};
  return result;
}

/// One frame of 48 views of 128 x 128 pixels.
LightCase quilt_of(const std::string& name, const Request& request) {
  LightCase result = quiet_case(name, scene_of_quilt(name), request);
  const int tile = request.quick ? kQuickTile : 128;
  result.still = true;
  result.params.optics.kind = OpticsKind::kMultiview;
  result.params.optics.size = {8 * tile, 6 * tile};
  return result;
}

LightCase hostile_case(const HostileScene& scene, const Request& request) {
  LightCase result = quiet_case(scene.name, scene.name, request);
  result.params = scene.params;
  result.build = scene.build;
  result.count = std::min(request.frames > 0 ? request.frames : request.quick ? kQuickFrames : scene.frames, scene.frames);
  result.reference_spp = kHostileReferenceSamples;
  result.row_share = scene.row_share;
  result.reference_step = request.quick ? 1 : scene.reference_step;
  result.equal_time = false;
  if (!request.quick) return result;
  RenderParams& params = result.params;
  if (params.optics.views.x > 0)
    params.optics.size = {kQuickTile * params.optics.views.x, kQuickTile * params.optics.views.y};
  else
    params.optics.lenses = {8, 8};
  return result;
}

/// One row of pixels of so many is compared where a picture has more than a hostile row's own: references take hours else.
int row_share_of(int width, int height) {
  constexpr int kComparedPixels = 3 * 120 * 120;
  return std::clamp(static_cast<int>(static_cast<std::int64_t>(width) * height / kComparedPixels), 1, height);
}

void choose_views(const Request& request, LightCase& wanted) {
  constexpr int kMostViews = 64, kViewPixels = 120;
  if (request.views.empty() && request.view_pixels == 0) return;
  const Extent<int> views = request.views.empty() ? Extent<int>{3, 1} : read_extent(request.views, 1, kMostViews, "--views");
  const int pixels = request.view_pixels > 0 ? request.view_pixels : kViewPixels;
  RenderParams& params = wanted.params;
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = {views.x, std::max(views.y, 1)}, params.optics.lenses = {};
  params.optics.size = {params.optics.views.x * pixels, params.optics.views.y * pixels};
  wanted.row_share = row_share_of(params.optics.size.x, params.optics.size.y);
}

LightCase light_case(const std::string& name, const Request& request, const Context& context) {
  check_name(name);
  const HostileScene* hostile = find_hostile(name);
  LightCase result = hostile          ? hostile_case(*hostile, request)
                     : is_quilt(name) ? quilt_of(name, request)
                                      : animation_of(name, request, context);
  if (request.quick) result.params.sampling.spp = kQuickSamples, result.reference_spp = kQuickReferenceSamples;
  choose_views(request, result);
  if (request.reference_spp > 0) result.reference_spp = request.reference_spp;
  return result;
}

}  // namespace

std::vector<LightCase> light_cases(const Request& request, const Context& context) {
  std::vector<std::string> names = request.scenes;
  if (names.empty()) {
    for (const QuietRow& row : quiet_rows()) names.push_back(row.name);
    for (const HostileScene& scene : hostile_scenes()) names.push_back(scene.name);
  }
  std::vector<LightCase> cases;
  cases.reserve(names.size());
  for (const std::string& name : names) cases.push_back(light_case(name, request, context));
  return cases;
}

std::optional<LightBar> light_bar(const std::string& row) {
  if (find_hostile(row)) return kHostileBar;
  for (const QuietRow& quiet : quiet_rows())
    if (quiet.name == row) return quiet.bar;
  return std::nullopt;
}

std::string light_row_list() {
  std::string text;
  for (const QuietRow& row : quiet_rows())
    text += fmt::format("{:<12} built-in scene, {}\n", row.name, is_quilt(row.name) ? "one still quilt" : "an animation");
  for (const HostileScene& scene : hostile_scenes()) text += fmt::format("{:<12} {}\n", scene.name, scene.difficulty);
  return text;
}

}  // namespace lippmann::bench
