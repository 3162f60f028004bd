// Figures in the reports of benchmarks.
#pragma once

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "bench/timing.hpp"

namespace lippmann::bench {

/// To three decimals; null where there is none, or where it is not finite: JSON has no infinity.
inline nlohmann::ordered_json rounded_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(rounded(*value)) : nlohmann::ordered_json(nullptr);
}

}  // namespace lippmann::bench
