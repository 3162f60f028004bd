#include "job/removed_params.hpp"

#include <fmt/core.h>

namespace lippmann {
namespace {

struct Removed {
  std::string_view name, value;  ///< empty `value`: the parameter itself was removed
  const char *why, *accepted;
};

constexpr Removed kRemoved[] = {
    {"reuse", "light", "path-traced frames are denoised instead", "--denoise auto (the default), --reuse auto or none"},
    {"time-budget", "", "it made pictures depend on the machine", "--spp, to which the time of a frame is proportional"},
    {"quality-at", "", "renders report the error of pixels only",
     "lippmann replay or compare, which measure the picture at an eye"},
    {"debug", "provenance", "a layer has the same data", "--debug missed; --aov provenance"},
};

}  // namespace

std::optional<Error> removal_of(std::string_view name, std::string_view value, const std::string& where) {
  for (const Removed& removed : kRemoved)
    if (removed.name == name && (removed.value.empty() || removed.value == value))
      return usage_error(where,
                         fmt::format("{}{}was removed: {}", removed.value, removed.value.empty() ? "" : " ", removed.why),
                         removed.accepted);
  return std::nullopt;
}

}  // namespace lippmann
