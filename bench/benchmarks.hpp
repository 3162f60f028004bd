// The functions behind benchmarks(), one per source file.
#pragma once

#include "bench/bench.hpp"

namespace lippmann::bench {

Report measure_png(const Context& context);
Report measure_rays(const Context& context);

}  // namespace lippmann::bench
