// A scene that is set up while it is looked at: settings come in, pictures of it come out, coarse ones at once and finer ones
// while nothing changes.
//
// One thread renders. A change cancels what it does; then it begins anew. While a job is rendered (LiveRender), coarse pictures
// alone are made, so that the job has the processor.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "lippmann/layout/interlace.hpp"
#include "live/live_job_file.hpp"
#include "live/live_passes.hpp"
#include "live/live_render.hpp"
#include "live/live_settings.hpp"
#include "live/live_stage.hpp"
#include "view/byte_cache.hpp"

namespace lippmann {

/// Thread-safe.
class LiveScene {
 public:
  /// Loads the scene, so that what cannot be shown is refused here, and begins to render. Jobs are saved to `job_file`
  /// (LiveJobFile). `warn` hears what Context::warn does. `interlace`: how a panel that it is played on mixes views. Throws
  /// Error.
  LiveScene(const LiveSettings& settings, std::filesystem::path job_file, std::function<void(std::string_view)> warn,
            const InterlaceParams& interlace = {});
  ~LiveScene();
  LiveScene(const LiveScene&) = delete;
  LiveScene& operator=(const LiveScene&) = delete;

  /// {"settings": {NAME: text or null}, "frame": N, "plane_mm": z}, all of which may be missing; `plane_mm` puts the plane
  /// where something is shown. All of it or, where it throws a usage Error, nothing is set. Returns the version of the
  /// settings.
  std::uint64_t change(const nlohmann::ordered_json& changes);

  /// What the page is told (docs/guide/view.md lists the keys), as soon as it is not that of `serial`, or after `patience`.
  nlohmann::ordered_json state_after(std::uint64_t serial, std::chrono::milliseconds patience) const;

  /// The facts of the light field as the last picture has it.
  nlohmann::ordered_json field() const;

  /// The slanted panel that the settings are for, as page_display_json has it; null: they are for another display, or for none.
  nlohmann::ordered_json display() const;
  const InterlaceParams& interlace() const { return interlace_; }

  /// Throws a usage Error where the views are more than one row, of which no panel's frame is made.
  void require_playable() const;

  /// "views", "depth" or "panel" of the picture of that number, while it is the last; null else.
  Bytes picture(std::string_view kind, std::uint64_t id) const;

  /// Whether there was a picture of that number that another has taken the place of.
  bool is_outdated(std::uint64_t id) const;

  /// Returns the file. Throws Error, also for settings that cannot be rendered.
  std::filesystem::path save();

  /// Starts a render of the whole job, or of the frame that is shown. Throws likewise.
  void render(bool all_frames);
  void cancel_render() { render_.cancel(); }

 private:
  struct Picture {
    std::uint64_t id = 0, version = 0;
    int frame = 0;
    std::string pass;
    Vec2i view_size{0, 0};
    Bytes views, depth, panel;
    nlohmann::ordered_json facts;  ///< field_json
  };
  /// The context of the thread that renders.
  struct WorkerContext : Context {
    explicit WorkerContext(std::function<void(std::string_view)> warner) { warn = std::move(warner); }
  };
  struct Order {
    LiveSettings settings;
    std::uint64_t version;
  };

  void work();
  std::optional<Order> next_order();
  void make(const Order& order);
  void begin(const Order& order);
  void publish(const Order& order, const char* pass, const LivePictures& made, const Bytes& depth);
  void end(const Order& order, const std::string& error, bool at_rest);
  nlohmann::ordered_json state() const;
  void require_sound() const;
  bool is_stale(std::uint64_t version) const;
  void tell();
  void set_plane(LiveSettings& settings, double z_mm) const;

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  WorkerContext context_;  ///< cancelled by changes
  LiveStage live_;         ///< that thread's
  const InterlaceParams interlace_;
  LiveSettings settings_;
  LiveJobFile job_file_;
  LiveRender render_;
  // Facts, placement and distance are those of the version begun last.
  PageFacts facts_;
  nlohmann::ordered_json facts_json_, placement_;
  double distance_ = 0.0, world_per_shown_mm_ = 0.0;  ///< world units; distance_: from the viewer to the plane, inf: none
  std::uint64_t serial_ = 1, version_ = 1, done_version_ = 0, broken_version_ = 0, next_id_ = 1;
  bool is_whole_ = false, ending_ = false;  ///< whether the last version has had all its passes
  std::string pass_, error_, saved_;
  std::atomic<double> share_{0.0};
  Picture picture_;
  std::thread worker_;  ///< last: it uses what is above
};

}  // namespace lippmann
