// Parameters and values of earlier versions, each with its replacement. Flags and job files that still use one get a clear
// error.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lippmann/core/error.hpp"

namespace lippmann {

/// Returns a usage Error if the parameter `name`, or its value `value`, was removed, and nullopt otherwise. `where` is the name
/// that the error shows, e.g. "--reuse".
std::optional<Error> removal_of(std::string_view name, std::string_view value, const std::string& where);

}  // namespace lippmann
