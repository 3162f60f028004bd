// Reads grids of views from flags, such as 8x6.
#pragma once

#include <optional>
#include <string>

#include "lippmann/layout/view_layout.hpp"

namespace lippmann::app {

/// Reads "COLUMNSxROWS", each from 1 to 1024. Returns nullopt for an empty text. Throws a usage Error naming the flag.
std::optional<ViewGrid> read_grid(const std::string& text, const std::string& flag);

}  // namespace lippmann::app
