// Shared helpers for tests of live scenes: small renders, and waiting for them.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "job/params.hpp"
#include "live/live_scene.hpp"

namespace lippmann::test {

/// Returns the built-in room on 4 views of 16x16 pixels.
RenderParams small_room();

std::unique_ptr<LiveScene> live_scene(const RenderParams& params, const std::filesystem::path& job_file = "unused.toml");

/// Returns the first state for which `is_it` holds; fails the test after ten minutes.
nlohmann::ordered_json wait_for(const LiveScene& scene, const std::function<bool(const nlohmann::ordered_json&)>& is_it);

/// Waits until the final picture of the present settings is shown.
nlohmann::ordered_json wait_for_rest(const LiveScene& scene);

/// Returns sRGB codes of the picture that is shown.
Image8 shown_picture(const LiveScene& scene, const std::string& kind);

/// Renders into the folder as `lippmann render` does, and returns the views of a frame as a page shows them.
Image8 views_of_render(RenderParams params, const std::filesystem::path& folder, int frame);

}  // namespace lippmann::test
