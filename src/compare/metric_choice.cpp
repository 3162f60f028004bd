#include "compare/metric_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::array<std::string_view, 10> kMetricNames{"psnr", "ssim",    "mse",     "psnr-y",  "psnr-yuv",
                                                        "flip", "ms-ssim", "angular", "flicker", "all"};

bool choose(std::string_view name, MetricChoice& choice) {
  const bool all = name == "all";
  choice.all = choice.all || all;
  bool known = all || name == "psnr" || name == "ssim" || name == "mse";
  const auto choose_if = [&](std::string_view this_name, bool& chosen, bool in_all = true) {
    if (name == this_name || (all && in_all)) chosen = known = true;
  };
  choose_if("psnr-y", choice.psnr_y);
  choose_if("psnr-yuv", choice.psnr_yuv);
  choose_if("ms-ssim", choice.slow.ms_ssim);
  choose_if("flip", choice.slow.flip);
  choose_if("angular", choice.angular, false);
  choose_if("flicker", choice.flicker, false);
  return known;
}

}  // namespace

MetricChoice read_metrics(const std::string& text) {
  MetricChoice choice;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    if (!choose(name, choice))
      throw usage_error("metrics", fmt::format("there is no metric {}{}", shown(name), did_you_mean(name, kMetricNames)),
                        "some of psnr-y, psnr-yuv, ms-ssim, flip, angular, flicker, separated by commas, or all");
    begin = end + 1;
  }
  return choice;
}

}  // namespace lippmann
