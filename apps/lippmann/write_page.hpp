// Writes the page of a render beside its frames (`render --page`).
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "view/saved_page.hpp"

namespace lippmann::app {

/// Writes the page of a folder of finished frames, and adds its files to the folder's checksums. Throws Error as save_page()
/// does.
SavedPage write_page(const std::filesystem::path& folder, const Context& context);

}  // namespace lippmann::app
