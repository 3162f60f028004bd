#include "live/live_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "job/params_table.hpp"
#include "job/scene_light.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"

namespace lippmann {
namespace {

constexpr std::array<std::string_view, 20> kNames{"focus",
                                                  "fit-to",
                                                  "zoom",
                                                  "orbit",
                                                  "light-scale",
                                                  "display",
                                                  "optics",
                                                  "views",
                                                  "view-angle",
                                                  "viewing-distance",
                                                  "fit-depth",
                                                  "integrator",
                                                  "spp",
                                                  "denoise",
                                                  "environment",
                                                  "environment-strength",
                                                  "environment-rotation",
                                                  "exposure",
                                                  "tone",
                                                  "clamp-indirect"};

std::string value_of(const ParamInfo& info, const RenderParams& params) {
  const std::vector<std::string> values = info.get(params);
  return values.empty() ? std::string() : fmt::format("{}", fmt::join(values, ","));
}

void refuse_files(const std::string& name, const std::string& value, const RenderParams& base) {
  if (name == "display" && !value.empty() && value != base.optics.display && is_display_file(value))
    throw usage_error("display", "the page accepts presets only",
                      fmt::format("a name of `lippmann displays`, or `lippmann view {} FILE`", flag_of("display")));
  if (name == "environment" && value != base.scene.environment && environment_is_file(value))
    throw usage_error("environment", "the page accepts no files",
                      fmt::format("none, studio, a colour, or `lippmann view {} FILE`", flag_of("environment")));
}

}  // namespace

std::span<const std::string_view> live_setting_names() { return kNames; }

LiveSettings::LiveSettings(RenderParams base) : base_(std::move(base)) {
  if (base_.output.frames) frame_ = base_.output.frames->front().first;
}

LiveSettings::LiveSettings(RenderParams base, RenderParams first) : LiveSettings(std::move(base)) { first_ = std::move(first); }

const RenderParams& LiveSettings::changed_params(const std::map<std::string, std::string>& changes) const {
  const auto is_set = [&](const std::string& name) { return changes.contains(name) && !changes.at(name).empty(); };
  return first_ && !is_set("optics") && !is_set("display") ? *first_ : base_;
}

RenderParams LiveSettings::applied(const std::map<std::string, std::string>& changes) const {
  RenderParams params = changed_params(changes);
  for (const auto& [name, value] : changes) find_param(name)->set(params, {value}, name);
  return params;
}

void LiveSettings::set(const std::string& name, const std::string* value) {
  if (std::find(kNames.begin(), kNames.end(), name) == kNames.end())
    throw usage_error(name, "cannot be set from the page", fmt::format("{}", fmt::join(kNames, ", ")));
  std::map<std::string, std::string> changes = changes_;
  if (!value) {
    changes.erase(name);
  } else {
    refuse_files(name, *value, base_);
    changes[name] = *value;
  }
  applied(changes);
  changes_ = std::move(changes);
}

void LiveSettings::set_frame(int frame, int frame_count) {
  if (frame < 0 || frame >= frame_count)
    throw usage_error("frame", fmt::format("{} is outside the animation", frame), fmt::format("0 to {}", frame_count - 1));
  frame_ = frame;
}

ResolvedJob LiveSettings::job() const { return ResolvedJob(applied(changes_)); }

nlohmann::ordered_json LiveSettings::values() const {
  const ResolvedJob all = job();
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (const std::string_view name : kNames) values[std::string(name)] = value_of(*find_param(name), all.params());
  return values;
}

nlohmann::ordered_json LiveSettings::changed() const {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const auto& [name, value] : changes_) names.push_back(name);
  return names;
}

}  // namespace lippmann
