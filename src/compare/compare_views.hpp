// Compares light fields view by view. Also measures whether errors are consistent between views and between frames.
#pragma once

#include <filesystem>

#include "compare/compare.hpp"

namespace lippmann {

Comparison compare_views(const std::filesystem::path& reference, const std::filesystem::path& test, const Context& context,
                         const CompareParams& params);

}  // namespace lippmann
