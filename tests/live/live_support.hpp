// Functions that tests of live scenes share: small renders, and waiting for their pictures.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "job/params.hpp"
#include "live/live_scene.hpp"

namespace lippmann::test {

/// Returns parameters of the built-in scene "room", with 4 views of 16 x 16 pixels.
RenderParams small_room();

std::unique_ptr<LiveScene> live_scene(const RenderParams& params, const std::filesystem::path& job_file = "unused.toml");

/// Waits for a state for which `is_it` returns true, and returns the state. The test fails after ten minutes.
nlohmann::ordered_json wait_for(const LiveScene& scene, const std::function<bool(const nlohmann::ordered_json&)>& is_it);

/// Waits until the scene shows the final picture for its settings, and returns the state.
nlohmann::ordered_json wait_for_rest(const LiveScene& scene);

/// Returns the sRGB codes of the current picture.
Image8 shown_picture(const LiveScene& scene, const std::string& kind);

/// Renders into the folder as `lippmann render` does. Returns the views of a frame in the layout in which the page shows them.
Image8 views_of_render(RenderParams params, const std::filesystem::path& folder, int frame);

}  // namespace lippmann::test
