// Small live renders, and waiting for their pictures.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "job/params.hpp"
#include "live/live_scene.hpp"

namespace lippmann::test {

RenderParams small_room();

std::unique_ptr<LiveScene> live_scene(const RenderParams& params, const std::filesystem::path& job_file = "unused.toml");

nlohmann::ordered_json wait_for(const LiveScene& scene, const std::function<bool(const nlohmann::ordered_json&)>& is_it);

nlohmann::ordered_json wait_for_rest(const LiveScene& scene);

Image8 shown_picture(const LiveScene& scene, const std::string& kind);

/// Renders a frame as `lippmann render` does. Returns its views in the layout that the page requests.
Image8 views_of_render(RenderParams params, const std::filesystem::path& folder, int frame);

}  // namespace lippmann::test
