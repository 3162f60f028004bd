// Answers the requests of a page that shows a live scene. Does not depend on sockets.
//
//   GET  live/state/SERIAL   LiveScene::state_after() as JSON; waits up to a second for changes
//   GET  live/views/ID, live/depth/ID, live/panel/ID   an image; an empty answer (204) if a newer image exists
//   POST live/settings       LiveScene::change(); answers {"version": N}
//   POST live/save           LiveScene::save(); answers {"file": NAME}
//   POST live/render         starts a render; the body is {"frames": "all"} or {"frames": "this"}
//   POST live/cancel         stops the render
// Refused requests are answered with status 422 and {"error": MESSAGE}.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>

#include "live/live_scene.hpp"
#include "view/answers.hpp"

namespace lippmann {

class LiveAnswers : public LivePage {
 public:
  /// If `plays` is true, the page first shows the panel's image instead of an eye view.
  explicit LiveAnswers(std::unique_ptr<LiveScene> scene, bool plays = false) : scene_(std::move(scene)), plays_(plays) {}

  nlohmann::ordered_json field() const override;
  nlohmann::ordered_json about() const override;
  InterlaceParams interlace() const override { return scene_->interlace(); }
  std::optional<std::filesystem::path> finished_render() const override { return scene_->finished_render(); }
  PageAnswer get(std::string_view path) override;
  PageAnswer post(std::string_view path, const std::string& body) override;

 private:
  PageAnswer state_after(std::uint64_t serial);

  std::unique_ptr<LiveScene> scene_;
  bool plays_;
  std::atomic<int> waiting_{0};
};

}  // namespace lippmann
