#include "live/live_support.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <span>
#include <utility>

#include "image/decode.hpp"
#include "job/animation.hpp"
#include "view/page_field.hpp"

namespace lippmann::test {

using Json = nlohmann::ordered_json;

RenderParams small_room() {
  RenderParams params;
  params.scene.name = "room";
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = {4, 1};
  params.optics.size = {64, 16};
  params.threads = 2;
  return params;
}

std::unique_ptr<LiveScene> live_scene(const RenderParams& params, const std::filesystem::path& job_file) {
  return std::make_unique<LiveScene>(params, job_file, [](std::string_view) {});
}

Json wait_for(const LiveScene& scene, const std::function<bool(const Json&)>& is_it) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(10);
  Json state = scene.state_after(0, std::chrono::milliseconds(0));
  while (!is_it(state) && std::chrono::steady_clock::now() < until)
    state = scene.state_after(state["serial"].get<std::uint64_t>(), std::chrono::milliseconds(200));
  EXPECT_TRUE(is_it(state)) << state.dump(1);
  return state;
}

Json wait_for_rest(const LiveScene& scene) {
  return wait_for(scene, [](const Json& state) {
    const Json& picture = state["picture"];
    return !picture.is_null() && picture["pass"] == "final" && picture["version"] == state["version"];
  });
}

Image8 shown_picture(const LiveScene& scene, const std::string& kind) {
  const Json state = scene.state_after(0, std::chrono::milliseconds(0));
  const Bytes bytes = scene.picture(kind, state["picture"]["id"].get<std::uint64_t>());
  if (!bytes) return {};
  const DecodedPicture decoded = decode_picture(std::as_bytes(std::span(*bytes)), kind);
  return {decoded.header.width, decoded.header.height, std::get<std::vector<std::uint8_t>>(decoded.samples)};
}

Image8 views_of_render(RenderParams params, const std::filesystem::path& folder, int frame) {
  const Context context;
  params.output.folder = folder.string();
  params.output.frames = FrameRanges{{frame, frame}};
  render_animation(ResolvedJob(params), context);
  return PageField(folder, LightFieldHints{}, context).quilt(0);
}

}  // namespace lippmann::test
