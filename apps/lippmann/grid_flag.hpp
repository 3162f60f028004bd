#pragma once

#include <optional>
#include <string>

#include "lippmann/layout/view_layout.hpp"

namespace lippmann::app {

/// Reads a grid of views as COLUMNSxROWS, each from 1 to 1024. Returns nullopt for an empty text. Throws a usage Error naming
/// the flag.
std::optional<ViewGrid> read_grid(const std::string& text, const std::string& flag);

}  // namespace lippmann::app
