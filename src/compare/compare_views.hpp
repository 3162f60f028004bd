// Compares light fields view by view, and the consistency of errors between views and frames.
#pragma once

#include <filesystem>

#include "compare/compare.hpp"

namespace lippmann {

/// Compares light fields like compare(), which calls this function if CompareParams::compares_views().
Comparison compare_views(const std::filesystem::path& reference, const std::filesystem::path& test, const Context& context,
                         const CompareParams& params);

}  // namespace lippmann
