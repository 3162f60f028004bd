// What a page may ask of a scene that is set up live: paths and bodies in, answers out; no sockets.
//
//   GET  live/state/SERIAL   LiveScene::state_after, as JSON; waits up to a second for news
//   GET  live/views/ID, live/depth/ID, live/panel/ID   a picture; nothing (204) when it is no longer the last
//   POST live/settings       LiveScene::change; {"version": N}
//   POST live/save           {"file": NAME}
//   POST live/render         {"frames": "all" or "this"}; live/cancel ends it
// What is refused is answered 422 with {"error": MESSAGE}.
#pragma once

#include <atomic>
#include <memory>

#include "live/live_scene.hpp"
#include "view/answers.hpp"

namespace lippmann {

class LiveAnswers : public LivePage {
 public:
  /// `plays`: whether the page begins with what a panel shows.
  explicit LiveAnswers(std::unique_ptr<LiveScene> scene, bool plays = false) : scene_(std::move(scene)), plays_(plays) {}

  nlohmann::ordered_json field() const override;
  nlohmann::ordered_json about() const override;
  InterlaceParams interlace() const override { return scene_->interlace(); }
  PageAnswer get(std::string_view path) override;
  PageAnswer post(std::string_view path, const std::string& body) override;

 private:
  PageAnswer state_after(std::uint64_t serial);

  std::unique_ptr<LiveScene> scene_;
  bool plays_;
  std::atomic<int> waiting_{0};
};

}  // namespace lippmann
