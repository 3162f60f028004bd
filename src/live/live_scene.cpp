#include "live/live_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "image/png.hpp"
#include "image/webp.hpp"
#include "lippmann/core/error.hpp"
#include "stage/depth_budget.hpp"
#include "view/answers.hpp"
#include "view/field_json.hpp"
#include "view/page_display.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

/// interval between looks at the scene's file
constexpr std::chrono::milliseconds kFileTick{500};

Bytes encoded(const Image8& picture) { return std::make_shared<const std::string>(encoded_picture(picture, 0).bytes); }

/// Describes the distance of the display plane from the viewer, and the limits of this distance, in world units.
Json plane_json(double distance, double nearest, double farthest) {
  if (!std::isfinite(distance)) return nullptr;
  return {{"distance", distance}, {"nearest", nearest}, {"farthest", farthest}};
}

/// Returns null for displays other than slanted panels, because only slanted panels interlace views.
Json panel_json(const Display* display, const InterlaceParams& interlace) {
  if (!display || display->kind != DisplayKind::kSlantedPanel) return nullptr;
  return page_display_json({*display, interlace});
}

}  // namespace

LiveScene::LiveScene(const LiveSettings& settings, std::filesystem::path job_file, std::function<void(std::string_view)> warn,
                     const InterlaceParams& interlace)
    : context_(std::move(warn)),
      live_(settings.job(), context_),
      interlace_(interlace),
      settings_(settings),
      job_file_(std::move(job_file)) {
  context_.frame_progress = [this](double share) { share_ = share; };
  begin({settings_, version_});
  worker_ = std::thread([this] { work(); });
}

LiveScene::~LiveScene() {
  render_.cancel();
  {
    const std::lock_guard lock(mutex_);
    ending_ = context_.cancelled = true;
  }
  changed_.notify_all();
  worker_.join();
}

void LiveScene::work() {
  while (const std::optional<Order> order = next_order()) {
    try {
      make(*order);
    } catch (const Error& error) {
      end(*order, error.what(), true);
    } catch (const std::bad_alloc&) {
      end(*order, "There is not enough memory for these settings.", true);
    }
  }
}

std::optional<LiveScene::Order> LiveScene::next_order() {
  std::unique_lock lock(mutex_);
  const auto has_work = [this] { return ending_ || done_version_ != version_ || (!is_whole_ && !render_.is_running()); };
  while (!changed_.wait_for(lock, kFileTick, has_work))
    if (live_.has_new_file()) begin_again();
  if (ending_) return std::nullopt;
  context_.cancelled = false;
  return Order{settings_, version_};
}

/// Publishes the facts of the light field before anything is traced. Called by the render thread only.
void LiveScene::begin(const Order& order) {
  const JobStage& stage = live_.stage();
  PageFacts facts = live_.facts();
  const FittedArray& array = stage.array;
  const PlacedOptics& placed = stage.placed;
  const double distance = array.viewing_distance;
  const ShownDepth shown = shown_depth(array, placed.units_per_mm, placed.depth_scale, placed.optics);
  Json placement{
      {"plane", plane_json(distance, array.viewing_distance - array.depth_front, array.viewing_distance - array.depth_back)},
      {"depth", depth_json(shown, placed.depth_scale, placed.optics)},
      {"view", array.how},
      {"light", stage.light},
      {"display", panel_json(stage.display.get(), interlace_)}};
  const std::lock_guard lock(mutex_);
  if (order.version != version_) return;
  // The page receives the list of frames only once.
  if (!facts_.frames.empty() && facts.frames.size() != facts_.frames.size())
    throw Error(facts.title, fmt::format("has {} frames, but had {} at first", facts.frames.size(), facts_.frames.size()),
                "a new start of `lippmann view`");
  facts_json_ = field_json(facts);
  facts_ = std::move(facts);
  placement_ = std::move(placement);
  distance_ = distance;
  world_per_shown_mm_ = placed.units_per_mm / placed.depth_scale;
}

bool LiveScene::is_stale(std::uint64_t version) const {
  const std::lock_guard lock(mutex_);
  return version != version_;
}

void LiveScene::make(const Order& order) {
  const int frame = order.settings.frame();
  live_.set(order.settings.job());
  begin(order);
  if (is_stale(order.version)) return;
  const PageFacts facts = facts_;  // needs no lock: only this thread changes facts_
  const auto depth_of = [&](Vec2i size) {
    return facts.has_depth ? encoded(depth_picture(live_, facts, size, frame)) : Bytes();
  };
  const auto pass = [&](const char* name) {
    const std::lock_guard lock(mutex_);
    if (order.version == version_) pass_ = name, share_ = 0.0;
  };
  pass("coarse");
  if (const auto coarse = coarse_pictures(live_, facts, frame, context_))
    publish(order, "coarse", *coarse, depth_of(coarse->view_size));
  if (context_.cancelled) return;
  if (render_.is_running()) return end(order, "", false);
  pass("draft");
  const Bytes depth = depth_of(facts.view_size);
  if (!context_.cancelled)
    if (const auto draft = draft_pictures(live_, facts, frame, context_)) publish(order, "draft", *draft, depth);
  pass("final");
  if (!context_.cancelled)
    if (const auto whole = finished_pictures(live_, facts, frame)) publish(order, "final", *whole, depth);
  if (!context_.cancelled) end(order, "", true);
}

void LiveScene::publish(const Order& order, const char* pass, const LivePictures& made, const Bytes& depth) {
  const Bytes views = encoded(made.views), panel = made.panel ? encoded(*made.panel) : Bytes();
  {
    const std::lock_guard lock(mutex_);
    if (order.version != version_) return;
    picture_ = {next_id_++, order.version, order.settings.frame(), pass, made.view_size, views, depth, panel, facts_json_};
    error_.clear();
    picture_.facts.erase("frames");  // the list of frames never changes, so the page gets it once
    ++serial_;
  }
  changed_.notify_all();
}

void LiveScene::end(const Order& order, const std::string& error, bool is_whole) {
  {
    const std::lock_guard lock(mutex_);
    if (order.version != version_) return;
    done_version_ = order.version;
    if (!error.empty()) broken_version_ = order.version;
    is_whole_ = is_whole, error_ = error, pass_.clear();
    ++serial_;
  }
  changed_.notify_all();
}

void LiveScene::set_plane(LiveSettings& settings, double z_mm) const {
  const double distance = distance_ - z_mm * world_per_shown_mm_;
  if (!std::isfinite(distance) || !(distance > 0.0))
    throw usage_error("plane_mm", fmt::format("{:g} mm lies behind the viewer", z_mm),
                      fmt::format("a depth below {:.4g} mm, where the viewer is", distance_ / world_per_shown_mm_));
  const std::string text = fmt::format("{:.6g}", distance);
  settings.set("focus", &text);
}

std::uint64_t LiveScene::change(const Json& changes) {
  if (!changes.is_object())
    throw usage_error("settings", "are not a JSON object", R"({"settings": {"zoom": "2"}, "frame": 0})");
  const std::lock_guard lock(mutex_);
  LiveSettings settings = settings_;
  for (const auto& [key, value] : changes.items()) {
    if (key == "frame" && value.is_number_integer()) {
      settings.set_frame(value.get<int>(), static_cast<int>(facts_.frames.size()));
    } else if (key == "plane_mm" && value.is_number()) {
      set_plane(settings, value.get<double>());
    } else if (key == "settings" && value.is_object()) {
      for (const auto& [name, text] : value.items()) {
        if (!text.is_string() && !text.is_null()) throw usage_error(name, "is not a text", "a text, or null");
        const std::string said = text.is_string() ? text.get<std::string>() : std::string();
        settings.set(name, text.is_string() ? &said : nullptr);
      }
    } else {
      throw usage_error(key, "is unknown or has a value of the wrong type", "settings, frame or plane_mm");
    }
  }
  settings_ = std::move(settings);
  begin_again();
  return version_;
}

/// Outdates the picture. The caller holds the mutex.
void LiveScene::begin_again() {
  context_.cancelled = true;
  ++version_, ++serial_;
  is_whole_ = false;
  pass_.clear();
  changed_.notify_all();
}

Json LiveScene::state() const {
  Json state{{"serial", serial_},
             {"version", version_},
             {"settings", settings_.values()},
             {"changed", settings_.changed()},
             {"frame", settings_.frame()},
             {"error", error_},
             {"pass", pass_},
             {"share", share_.load()}};
  state.update(placement_);
  state["picture"] = nullptr;
  if (picture_.id > 0)
    state["picture"] = {{"id", picture_.id},
                        {"version", picture_.version},
                        {"frame", picture_.frame},
                        {"pass", picture_.pass},
                        {"view_size", {picture_.view_size.x, picture_.view_size.y}},
                        {"depth", picture_.depth != nullptr},
                        {"panel", picture_.panel != nullptr},
                        {"field", picture_.facts}};
  state["saved"] = saved_;
  state["render"] = render_.json();
  return state;
}

Json LiveScene::state_after(std::uint64_t serial, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [&] { return serial_ != serial || ending_; });
  return state();
}

Json LiveScene::field() const {
  const std::lock_guard lock(mutex_);
  return facts_json_;
}

Json LiveScene::display() const {
  const std::lock_guard lock(mutex_);
  return placement_.at("display");
}

void LiveScene::require_playable() const {
  const std::lock_guard lock(mutex_);
  require_one_row(facts_);
}

Bytes LiveScene::picture(std::string_view kind, std::uint64_t id) const {
  const std::lock_guard lock(mutex_);
  if (id != picture_.id) return {};
  if (kind == "views") return picture_.views;
  return kind == "depth" ? picture_.depth : kind == "panel" ? picture_.panel : Bytes();
}

bool LiveScene::is_outdated(std::uint64_t id) const {
  const std::lock_guard lock(mutex_);
  return id > 0 && id < picture_.id;
}

void LiveScene::require_renderable() const {
  if (broken_version_ == version_) throw Error("settings", error_);
}

std::filesystem::path LiveScene::save() {
  const std::lock_guard lock(mutex_);
  require_renderable();
  const std::filesystem::path file = job_file_.save(settings_.job());
  saved_ = file.string();
  ++serial_;
  changed_.notify_all();
  return file;
}

void LiveScene::render(bool all_frames) {
  RenderParams params;
  {
    const std::lock_guard lock(mutex_);
    require_renderable();
    params = settings_.job().params();
    const int frame = settings_.frame();
    if (!all_frames) params.output.frames = FrameRanges{{frame, frame}};
  }
  render_.start(ResolvedJob(params), [this] { notify_pages(); });
  // Stops making finer images of the scene, until the job is rendered.
  context_.cancelled = true;
  notify_pages();
}

void LiveScene::notify_pages() {
  {
    const std::lock_guard lock(mutex_);
    ++serial_;
  }
  changed_.notify_all();
}

}  // namespace lippmann
