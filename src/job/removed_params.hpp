// Parameters and values that earlier versions accepted. Flags and job files that still use one get an error that names the
// replacement.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lippmann/core/error.hpp"

namespace lippmann {

/// Returns a usage Error if the parameter `name`, or its value `value`, was removed. Returns nullopt otherwise. `where` is the
/// name that the error shows, such as "--reuse".
std::optional<Error> removal_of(std::string_view name, std::string_view value, const std::string& where);

}  // namespace lippmann
