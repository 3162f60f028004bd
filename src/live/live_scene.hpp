// Renders a scene while its settings change: first a coarse image, then finer ones. A single thread renders. While a
// job is rendered (LiveRender), only coarse images are made.
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

class LiveScene {
 public:
  /// Loads the scene and starts rendering. Jobs are saved to `job_file`. `warn` is called like Context::warn.
  /// `interlace` describes how a panel interlaces views. Throws Error if the scene cannot be shown.
  LiveScene(const LiveSettings& settings, std::filesystem::path job_file, std::function<void(std::string_view)> warn,
            const InterlaceParams& interlace = {});
  ~LiveScene();
  LiveScene(const LiveScene&) = delete;
  LiveScene& operator=(const LiveScene&) = delete;

  /// Applies {"settings": {NAME: text or null}, "frame": N, "plane_mm": z}, in which each key is optional. plane_mm moves the
  /// display plane to depth z of the shown image. Throws a usage Error and changes nothing if a value is invalid. Returns the
  /// version of the settings.
  std::uint64_t change(const nlohmann::ordered_json& changes);

  /// Returns the state for the page when its serial number differs from `serial`, or after `patience`. web/README.md lists the
  /// keys.
  nlohmann::ordered_json state_after(std::uint64_t serial, std::chrono::milliseconds patience) const;

  nlohmann::ordered_json field() const;

  /// Describes the slanted panel of the settings (page_display_json()); null for other displays.
  nlohmann::ordered_json display() const;
  const InterlaceParams& interlace() const { return interlace_; }

  /// Throws a usage Error if the views have more than one row, which panels cannot interlace.
  void require_playable() const;

  /// `kind`: "views", "depth" or "panel". Returns null if a newer image exists.
  Bytes picture(std::string_view kind, std::uint64_t id) const;

  bool is_outdated(std::uint64_t id) const;

  /// Saves the job and returns its path. Throws Error if the settings cannot be rendered or the file cannot be written.
  std::filesystem::path save();

  /// Renders the whole job, or the current frame only. Throws Error if the settings cannot be rendered.
  void render(bool all_frames);
  void cancel_render() { render_.cancel(); }
  /// Returns the folder of the last render; nullopt if it has not finished.
  std::optional<std::filesystem::path> finished_render() const { return render_.finished_folder(); }

 private:
  struct Picture {
    std::uint64_t id = 0, version = 0;
    int frame = 0;
    std::string pass;
    Vec2i view_size{0, 0};
    Bytes views, depth, panel;
    nlohmann::ordered_json facts;
  };
  struct WorkerContext : Context {
    explicit WorkerContext(std::function<void(std::string_view)> warner) { warn = std::move(warner); }
  };
  struct Order {
    LiveSettings settings;
    std::uint64_t version;
  };

  void work();
  std::optional<Order> next_order();
  void begin_again();
  void make(const Order& order);
  void begin(const Order& order);
  void publish(const Order& order, const char* pass, const LivePictures& made, const Bytes& depth);
  void end(const Order& order, const std::string& error, bool at_rest);
  nlohmann::ordered_json state() const;
  void require_renderable() const;
  bool is_stale(std::uint64_t version) const;
  void notify_pages();
  void set_plane(LiveSettings& settings, double z_mm) const;

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  WorkerContext context_;
  LiveStage live_;  ///< used by the render thread only
  const InterlaceParams interlace_;
  LiveSettings settings_;
  LiveJobFile job_file_;
  LiveRender render_;
  // State of the latest settings that the render thread has begun to render. distance_: from the viewer to the display plane,
  // in world units. world_per_shown_mm_: world units per mm of shown depth.
  PageFacts facts_;
  nlohmann::ordered_json facts_json_, placement_;
  double distance_ = 0.0, world_per_shown_mm_ = 0.0;
  std::uint64_t serial_ = 1, version_ = 1, done_version_ = 0, broken_version_ = 0, next_id_ = 1;
  bool is_whole_ = false, ending_ = false;
  std::string pass_, error_, saved_;
  std::atomic<double> share_{0.0};
  Picture picture_;
  std::thread worker_;  ///< last member, because the thread uses all other members
};

}  // namespace lippmann
