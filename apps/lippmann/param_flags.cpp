#include "apps/lippmann/param_flags.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "apps/lippmann/command_line.hpp"
#include "job/idle_flags.hpp"
#include "job/job_file.hpp"
#include "job/params_table.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {
namespace {

std::string default_text(const ParamInfo& info) {
  const std::vector<std::string> values = info.get(RenderParams{});
  return values.empty() ? "" : fmt::format(" [{}]", values.front());
}

void add_param(const Command& command, const ParamInfo& info, std::vector<std::string>& values) {
  const std::string flag = fmt::format("{}--{}", info.name == "output" ? "-o," : "", info.name);
  const std::string group(info.group), doc(info.doc);
  if (info.kind == ParamKind::kFlag) {
    const auto add = [&](const std::string& name, const char* value, const std::string& words) {
      command
          .add_flag(
              name, [&values, value] { values.emplace_back(value); }, words)
          .group(group);
    };
    add(flag, "true", doc);
    if (!info.opposite.empty()) add(fmt::format("--{}", info.opposite), "false", std::string(info.opposite_doc));
    return;
  }
  const Flag option = command.add_option(flag, values, doc + default_text(info));
  option.type_name(std::string(info.type)).group(group);
  if (info.kind != ParamKind::kList) option.single();
  option.one_word_each();
}

std::vector<std::string_view> given(const ParamFlags& flags) {
  std::vector<std::string_view> names;
  for (const auto& [name, texts] : flags.values)
    if (!texts.empty()) names.push_back(name);
  return names;
}

/// Sets the parameter `display` to a description of the lenticular sheet. The description includes the viewing angle and the
/// viewing distance, because the pitch of the print depends on them.
void set_sheet(const ParamFlags& flags, RenderParams& params) {
  const auto text_of = [&](std::string_view name) {
    const auto found = flags.values.find(name);
    return found == flags.values.end() || found->second.empty() ? std::string() : found->second.back();
  };
  const std::string line = flags.sheet.line({text_of("display"), text_of("viewing-distance"), text_of("view-angle")});
  find_param("display")->set(params, {line}, "--display");
}

RenderParams asked(const ParamFlags& flags) {
  RenderParams params;
  const bool scene_is_job = std::filesystem::path(flags.scene).extension() == ".toml";
  if (scene_is_job && !flags.job.empty())
    throw usage_error("--job", "cannot be combined with a job as SCENE", "one of the two");
  if (scene_is_job || !flags.job.empty()) read_job(scene_is_job ? flags.scene : flags.job, params);
  if (!flags.scene.empty() && !scene_is_job) params.scene.name = flags.scene;
  for (const std::string_view name : given(flags)) {
    const std::vector<std::string>& texts = flags.values.at(name);
    const ParamInfo& info = *find_param(name);
    if (info.kind == ParamKind::kFlag && texts.size() > 1)
      throw usage_error(fmt::format("--{}", name), fmt::format("contradicts --{}", info.opposite), "one of the two");
    info.set(params, texts, fmt::format("--{}", name));
  }
  if (flags.sheet.are_given()) set_sheet(flags, params);
  if (params.scene.name.empty())
    throw usage_error("SCENE", "is missing", "a built-in name (see: lippmann scenes), a file, or a job");
  return params;
}

}  // namespace

RenderParams ParamFlags::read() const {
  RenderParams params = asked(*this);
  refuse_idle_flags(given(*this), ResolvedJob(params));
  return params;
}

ResolvedJob ParamFlags::resolve() const {
  ResolvedJob resolved(asked(*this));
  refuse_idle_flags(given(*this), resolved);
  return resolved;
}

void add_param_flags_beside(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> unwanted) {
  for (const ParamInfo& info : params_table())
    if (info.name != "scene" && std::find(unwanted.begin(), unwanted.end(), info.name) == unwanted.end())
      add_param(command, info, flags.values[info.name]);
}

void add_param_flags(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> wanted) {
  command.add_option(
      "SCENE", flags.scene,
      "A built-in name (see: lippmann scenes), test-pattern, a file (.gltf, .glb, .dat, .nff, .obj, .ply), or a job (.toml)");
  for (const ParamInfo& info : params_table()) {
    const bool listed =
        std::any_of(wanted.begin(), wanted.end(), [&](auto word) { return word == info.name || word == info.group; });
    if ((listed || wanted.size() == 0) && info.name != "scene") add_param(command, info, flags.values[info.name]);
  }
  add_sheet_flags(command, flags.sheet);
  command.add_option("--job", flags.job, "A job file (.toml); flags override its values").type_name("FILE").group("Scene");
}

}  // namespace lippmann::app
