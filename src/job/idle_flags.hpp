// Flags that would change nothing in a render. A flag without effect is the user's mistake, and is refused.
#pragma once

#include <span>
#include <string_view>

#include "job/resolved_job.hpp"

namespace lippmann {

/// Throws a usage Error for the first of `given` (names of parameters, as in params_table) that has no effect on the job. The
/// error says what would give it one. Parameters that other set-up code refuses where they mean nothing (such as `lenses`) are
/// not repeated here.
void refuse_idle_flags(std::span<const std::string_view> given, const ResolvedJob& job);

}  // namespace lippmann
