#include "apps/lippmann/scene_to_set_up.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "apps/lippmann/command_line.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

/// Initial number of views, and width and height of a view in pixels. The default view size of renders suits lens arrays, but
/// is too coarse for views shown one at a time.
constexpr int kFirstViews = 8, kFirstViewSide = 360;

void refuse_light_field_flags(const LightFieldFlags& field) {
  constexpr const char* kAccepted = "a rendered folder as IN";
  if (!field.from.empty()) throw usage_error("--from", "has no effect: IN is a scene", kAccepted);
  if (!field.report.empty()) throw usage_error("--report", "has no effect: IN is a scene", kAccepted);
}

}  // namespace

void add_scene_to_set_up_flags(const Command& command, SceneToSetUpFlags& flags,
                               std::initializer_list<std::string_view> unwanted) {
  command
      .add_option("--save-job", flags.job_file,
                  "For a scene: the job that Save on the page writes; default: SCENE.toml, or SCENE-2.toml if that exists")
      .type_name("FILE");
  add_param_flags_beside(command, flags.params, unwanted);
}

bool is_scene_to_set_up(const std::string& in) {
  constexpr std::array<std::string_view, 7> kEndings{".gltf", ".glb", ".dat", ".nff", ".obj", ".ply", ".toml"};
  std::error_code ignored;
  if (fs::is_directory(in, ignored)) return false;
  return is_builtin_scene(in) ||
         std::find(kEndings.begin(), kEndings.end(), fs::path(in).extension().string()) != kEndings.end();
}

void refuse_scene_flags(const std::string& in, const SceneToSetUpFlags& flags) {
  if (!flags.job_file.empty()) throw usage_error("--save-job", "has no effect: IN is a light field", "a scene as IN");
  for (const auto& [name, values] : flags.params.values)
    if (!values.empty())
      throw usage_error(
          fmt::format("--{}", name), fmt::format("has no effect: {} is read as a light field", in),
          "a built-in name (see: lippmann scenes), a file (.gltf, .glb, .dat, .nff, .obj, .ply) or a job (.toml)");
}

RenderParams scene_params(const std::string& in, const SceneToSetUpFlags& flags, const LightFieldFlags& field, int threads) {
  refuse_light_field_flags(field);
  ParamFlags all = flags.params;
  all.scene = in;
  all.sheet = field.sheet;
  if (!field.views.empty()) all.values["views"] = {field.views};
  if (!field.quilt.empty()) all.values["quilt"] = {field.quilt};
  if (!field.display.empty()) all.values["display"] = {field.display};
  if (field.view_angle_deg) all.values["view-angle"] = {fmt::format("{}", *field.view_angle_deg)};
  if (field.cone_ends) all.values["cone-ends"] = {"true"};
  if (threads > 0) all.values["threads"] = {fmt::format("{}", threads)};
  return all.read();
}

LiveSettings first_settings(const RenderParams& params, const std::string& in) {
  const OpticsParams& optics = params.optics;
  const bool takes_kind =
      std::any_of(kKindParams.begin(), kKindParams.end(), [&](const KindParam& one) { return one.is_given(optics); });
  const bool is_said = !optics.display.empty() || optics.kind || takes_kind || optics.size.x > 0 || optics.precompensate;
  if (is_said || params.output.pictures.layout || !params.output.pictures.to.empty() || fs::path(in).extension() == ".toml")
    return params;
  RenderParams views = params;
  views.optics.kind = OpticsKind::kMultiview;
  views.optics.views = {kFirstViews, 1};
  views.optics.size = {kFirstViews * kFirstViewSide, kFirstViewSide};
  return {params, views};
}

fs::path job_file_for(const SceneToSetUpFlags& flags, const RenderParams& params) {
  if (!flags.job_file.empty()) return flags.job_file;
  return fs::path(params.scene.name).stem().string() + ".toml";
}

}  // namespace lippmann::app
