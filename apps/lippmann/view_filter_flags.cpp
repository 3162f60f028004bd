#include "apps/lippmann/view_filter_flags.hpp"

#include "apps/lippmann/command_line.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {
namespace {

ViewFilter read_view_filter(const std::string& word) {
  if (word == "linear") return ViewFilter::kLinear;
  return word == "gaussian" ? ViewFilter::kGaussian : ViewFilter::kNearest;
}

}  // namespace

InterlaceParams ViewFilterFlags::read() const {
  InterlaceParams params{read_view_filter(filter)};
  if (sigma > 0.0 && params.filter != ViewFilter::kGaussian)
    throw usage_error("--sigma", "has no effect without --filter gaussian", "--filter gaussian");
  if (sigma > 0.0) params.sigma_views = sigma;
  return params;
}

void add_view_filter_flags(const Command& command, ViewFilterFlags& flags, const std::string& of) {
  command.add_option("--filter", flags.filter, "Filter between views" + of + ": nearest (default), linear or gaussian")
      .one_of({"nearest", "linear", "gaussian"});
  command.add_option("--sigma", flags.sigma, "Width of --filter gaussian, in views; default: 0.5").range(0.1, 10.0);
}

}  // namespace lippmann::app
