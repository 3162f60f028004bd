// Writes the page beside the frames of a render (`render --page`). The page belongs to the render, whose journal lists its
// files.
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "view/saved_page.hpp"

namespace lippmann::app {

/// Writes and records the page of a folder whose frames are all finished. Fails like save_page.
SavedPage write_page(const std::filesystem::path& folder, const Context& context);

}  // namespace lippmann::app
