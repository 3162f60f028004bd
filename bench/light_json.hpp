// The figures of one row of `lippmann bench light` for scripts.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "bench/light_rows.hpp"
#include "bench/light_run.hpp"

namespace lippmann::bench {

/// An object whose keys docs/light.md explains; what is not a number, or infinite, is null.
nlohmann::ordered_json light_json(const LightCase& wanted, const LightRun& run, const std::optional<LightBar>& bar);

}  // namespace lippmann::bench
