// The page beside the frames of a render (`render --page`), which belongs to the render: its journal names the page's files.
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "view/saved_page.hpp"

namespace lippmann::app {

/// Writes the page of a folder whose frames are all finished, and records it. As save_page.
SavedPage write_page(const std::filesystem::path& folder, const Context& context);

}  // namespace lippmann::app
