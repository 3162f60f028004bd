// Parameters and values of earlier versions, each with what replaces it: flags and job files that still have one get one clear
// error.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lippmann/core/error.hpp"

namespace lippmann {

/// The usage Error for a parameter, or for a value of one, that was removed; none: it was not. `where` names the place:
/// "--reuse".
std::optional<Error> removal_of(std::string_view name, std::string_view value, const std::string& where);

}  // namespace lippmann
