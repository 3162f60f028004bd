// Writes the page of a render beside its frames (`render --page`).
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "view/saved_page.hpp"

namespace lippmann::app {

/// Writes the page of a folder whose frames are all finished, and records its files in the journal. Throws Error as save_page()
/// does.
SavedPage write_page(const std::filesystem::path& folder, const Context& context);

}  // namespace lippmann::app
