#pragma once

#include "bench/bench.hpp"

namespace lippmann::bench {

Report measure_denoise(const Request& request, const Context& context);
Report measure_estimates(const Request& request, const Context& context);
Report measure_splats(const Request& request, const Context& context);
Report measure_lamps(const Request& request, const Context& context);
Report measure_light(const Request& request, const Context& context);
Report measure_native(const Request& request, const Context& context);
Report measure_paper(const Request& request, const Context& context);
Report measure_png(const Request& request, const Context& context);
Report measure_rays(const Request& request, const Context& context);
Report measure_replay(const Request& request, const Context& context);
Report measure_reuse(const Request& request, const Context& context);
Report measure_spheres(const Request& request, const Context& context);
Report measure_tachyon(const Request& request, const Context& context);

}  // namespace lippmann::bench
