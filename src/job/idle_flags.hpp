// Refuses flags that have no effect on a render, as they are probably mistakes.
#pragma once

#include <span>
#include <string_view>

#include "job/resolved_job.hpp"

namespace lippmann {

/// Throws a usage Error for the first of `given` (parameter names as in params_table) that has no effect on the job. The error
/// names settings with which the parameter has an effect. Parameters that other set-up code refuses (such as `lenses`) are not
/// checked again here.
void refuse_idle_flags(std::span<const std::string_view> given, const ResolvedJob& job);

}  // namespace lippmann
