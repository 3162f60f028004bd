#include "live/live_page.hpp"

#include <charconv>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/json_text.hpp"
#include "job/params_table.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

/// Number of requests that may wait for changes at the same time. Further requests are answered at once.
constexpr int kMaxWaiting = 8;
constexpr std::chrono::milliseconds kPatience{250};

PageAnswer json_answer(const Json& json, int status = 200) {
  return {status, "application/json", std::make_shared<const std::string>(json_to_text(json, -1))};
}

PageAnswer not_found() {
  return {404, "text/plain; charset=utf-8", std::make_shared<const std::string>("There is nothing with this name.\n")};
}

std::optional<std::uint64_t> number_of(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

Json choices_json() {
  Json choices = Json::object();
  for (const std::string_view name : live_setting_names()) {
    const ParamInfo& info = *find_param(name);
    if (!info.choices.empty()) choices[std::string(name)] = Json(info.choices);
  }
  choices["display"] = Json::array();
  for (const Display& display : display_presets()) choices["display"].push_back(display.name);
  return choices;
}

/// Returns true for the body {"frames": "all"}, and false for {"frames": "this"}.
bool wants_all(const std::string& body) {
  const Json json = json_from_text(body);
  const auto frames = json.is_object() ? json.value("frames", Json()) : Json();
  if (frames != "all" && frames != "this")
    throw usage_error("frames", "does not select frames", "\"all\", or \"this\" for the shown frame");
  return frames == "all";
}

}  // namespace

Json LiveAnswers::field() const { return scene_->field(); }

Json LiveAnswers::about() const { return {{"choices", choices_json()}, {"display", scene_->display()}, {"plays", plays_}}; }

PageAnswer LiveAnswers::state_after(std::uint64_t serial) {
  const bool may_wait = waiting_.fetch_add(1) < kMaxWaiting;
  const Json state = scene_->state_after(serial, may_wait ? kPatience : std::chrono::milliseconds(0));
  --waiting_;
  return json_answer(state);
}

PageAnswer LiveAnswers::get(std::string_view path) {
  const std::size_t slash = path.find('/');
  const std::string_view kind = path.substr(0, slash);
  const auto number = number_of(slash == std::string_view::npos ? std::string_view() : path.substr(slash + 1));
  if (!number) return not_found();
  if (kind == "state") return state_after(*number);
  const Bytes bytes = scene_->picture(kind, *number);
  if (!bytes) return scene_->is_outdated(*number) ? PageAnswer{204, "text/plain", nullptr} : not_found();
  return {200, bytes->starts_with("RIFF") ? "image/webp" : "image/png", bytes};
}

PageAnswer LiveAnswers::post(std::string_view path, const std::string& body) {
  try {
    if (path == "settings") return json_answer({{"version", scene_->change(json_from_text(body))}});
    if (path == "save") return json_answer({{"file", scene_->save().string()}});
    if (path == "render") return scene_->render(wants_all(body)), json_answer({{"started", true}});
    if (path == "cancel") return scene_->cancel_render(), json_answer({{"cancelled", true}});
  } catch (const Error& error) {
    return json_answer({{"error", error.what()}}, 422);
  }
  return not_found();
}

}  // namespace lippmann
