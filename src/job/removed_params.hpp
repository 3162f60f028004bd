// Parameters and values that earlier versions accepted.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lippmann/core/error.hpp"

namespace lippmann {

/// Returns a usage Error that names the replacement if the parameter `name`, or its value `value`, was removed. `where`
/// is the name that the error shows, such as "--reuse".
std::optional<Error> removal_of(std::string_view name, std::string_view value, const std::string& where);

}  // namespace lippmann
