// The figures of one row of `lippmann bench light` for people, beside the bars that they have to clear.
#pragma once

#include <optional>
#include <string>

#include "bench/light_rows.hpp"
#include "bench/light_run.hpp"

namespace lippmann::bench {

/// Several lines, with a heading. `bar`: none is asked of scenes of the user's own.
std::string light_text(const LightCase& wanted, const LightRun& run, const std::optional<LightBar>& bar);

}  // namespace lippmann::bench
