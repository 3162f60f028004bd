#pragma once

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "bench/timing.hpp"

namespace lippmann::bench {

/// Returns the value, rounded to three decimals, or null if it is missing or not finite.
inline nlohmann::ordered_json rounded_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(rounded(*value)) : nlohmann::ordered_json(nullptr);
}

}  // namespace lippmann::bench
