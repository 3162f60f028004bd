#include "bench/light_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "bench/hostile_scenes.hpp"
#include "bench/scenes.hpp"
#include "job/job_scene.hpp"
#include "job/param_text.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/builtin.hpp"

namespace lippmann::bench {
namespace {

constexpr int kFrames = 3;
constexpr int kQuickReferenceSamples = 64, kQuickViewPixels = 16;
constexpr std::string_view kQuilt = "-quilt";
constexpr const char* kQuietRows[] = {"teapot", "room", "small-balls", "tree", "room-quilt", "tree-quilt"};

const HostileScene* find_hostile(const std::string& name) {
  for (const HostileScene& scene : hostile_scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

bool is_quilt(const std::string& name) { return name.ends_with(kQuilt); }
std::string scene_of_row(const std::string& name) {
  return is_quilt(name) ? name.substr(0, name.size() - kQuilt.size()) : name;
}

void check_name(const std::string& name) {
  if (find_hostile(name) || is_builtin_scene(scene_of_row(name)) || std::filesystem::exists(scene_of_row(name))) return;
  std::string known;
  for (const char* row : kQuietRows) known += std::string(row) + ", ";
  for (const HostileScene& hostile : hostile_scenes()) known += hostile.name + ", ";
  throw usage_error("--scene", fmt::format("there is no row '{}' and no such file", name),
                    known + "another built-in scene or a file, or one of these with " + std::string(kQuilt));
}

void set_views(Extent<int> views, int pixels, RenderParams& params) {
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = views, params.optics.lenses = {};
  params.optics.size = {views.x * pixels, views.y * pixels};
}

/// Selects consecutive frames that begin at one third of the timeline, where all objects have moved. `all` is the number of
/// frames of the timeline.
void set_frames(int all, const Request& request, LightCase& row) {
  row.count = std::min(request.frames > 0 ? request.frames : is_quilt(row.name) ? 1 : kFrames, all);
  row.first = std::min(all / 3, all - row.count);
}

LightCase quiet_case(const std::string& name, const Request& request, const Context& context) {
  LightCase row{name, params_of(scene_of_row(name))};
  row.params.sampling.integrator = Integrator::kPath;
  if (is_quilt(name))
    set_views({8, 6}, 64, row.params);
  else
    set_views({8, 1}, 128, row.params);
  set_frames(load_scene_of(ResolvedJob(row.params), context).scene.timeline.frame_count, request, row);
  return row;
}

LightCase hostile_case(const HostileScene& scene, const Request& request) {
  LightCase row{scene.name, scene.params, scene.build};
  set_frames(scene.frames, request, row);
  return row;
}

/// Sets the number and size of the views as the request states them.
void choose_views(const Request& request, RenderParams& params) {
  constexpr int kMostViews = 64, kViewPixels = 120;
  if (request.views.empty() && request.view_pixels == 0) return;
  const Extent<int> views = request.views.empty() ? Extent<int>{3, 1} : read_extent(request.views, 1, kMostViews, "--views");
  set_views({views.x, std::max(views.y, 1)}, request.view_pixels > 0 ? request.view_pixels : kViewPixels, params);
}

void make_quick(LightCase& row) {
  row.reference_spp = kQuickReferenceSamples;
  if (row.params.optics.views.x > 0)
    set_views(row.params.optics.views, kQuickViewPixels, row.params);
  else
    row.params.optics.lenses = {8, 8};
}

LightCase light_case(const std::string& name, const Request& request, const Context& context) {
  check_name(name);
  const HostileScene* hostile = find_hostile(name);
  LightCase row = hostile ? hostile_case(*hostile, request) : quiet_case(name, request, context);
  if (request.quick) make_quick(row);
  choose_views(request, row.params);
  if (request.reference_spp > 0) row.reference_spp = request.reference_spp;
  return row;
}

}  // namespace

std::vector<LightCase> light_cases(const Request& request, const Context& context) {
  std::vector<std::string> names = request.scenes;
  if (names.empty()) {
    names.assign(std::begin(kQuietRows), std::end(kQuietRows));
    for (const HostileScene& scene : hostile_scenes()) names.push_back(scene.name);
  }
  std::vector<LightCase> cases;
  for (const std::string& name : names) cases.push_back(light_case(name, request, context));
  return cases;
}

std::string light_row_list() {
  std::string text;
  for (const std::string row : kQuietRows)
    text += fmt::format("{:<12} built-in scene, {}\n", row, is_quilt(row) ? "48 views of 64x64" : "8 views of 128x128");
  for (const HostileScene& scene : hostile_scenes()) text += fmt::format("{:<12} {}\n", scene.name, scene.difficulty);
  return text;
}

}  // namespace lippmann::bench
