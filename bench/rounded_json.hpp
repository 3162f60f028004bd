// Rounds numbers for the reports of benchmarks.
#pragma once

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "bench/timing.hpp"

namespace lippmann::bench {

/// Returns the value, rounded to three decimals. Returns null if it is missing or not finite, because JSON has no infinity.
inline nlohmann::ordered_json rounded_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(rounded(*value)) : nlohmann::ordered_json(nullptr);
}

}  // namespace lippmann::bench
