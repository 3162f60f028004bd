// Rejects flags that have no effect on a render, because they are probably mistakes.
#pragma once

#include <span>
#include <string_view>

#include "job/resolved_job.hpp"

namespace lippmann {

/// Throws a usage Error for the first parameter of `given` (names in params_table) that has no effect on the job. The error
/// names settings with which the parameter has an effect. Parameters that other set-up code checks, such as `lenses`, are not
/// checked.
void refuse_idle_flags(std::span<const std::string_view> given, const ResolvedJob& job);

}  // namespace lippmann
