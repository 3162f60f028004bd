#include "lippmann/formats/formats.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

const LightFieldFormat& format_named(std::string_view name, std::string_view flag,
                                     const std::vector<std::string_view>& accepted) {
  const std::vector<LightFieldFormat>& all = light_field_formats();
  const auto found = std::ranges::find(all, name, &LightFieldFormat::name);
  if (found != all.end()) return *found;
  throw usage_error(std::string(flag), fmt::format("unknown format '{}'{}", name, did_you_mean(name, accepted)),
                    fmt::format("{}", fmt::join(accepted, ", ")));
}

std::vector<std::string_view> format_names(bool only_written) {
  std::vector<std::string_view> names;
  for (const LightFieldFormat& format : light_field_formats())
    if (!only_written || format.write != nullptr) names.push_back(format.name);
  return names;
}

}  // namespace

const std::vector<LightFieldFormat>& light_field_formats() {
  static const std::vector<LightFieldFormat> all{integral_format(), quilt_format(),      views_format(),   hci_format(),
                                                 stanford_format(), jpeg_pleno_format(), eslf_format(),    plenoptic_format(),
                                                 miv_format(),      nerf_format(),       colmap_format(),  llff_format(),
                                                 stereo_format(),   quad_format(),       rgbd_format(),    native_format(),
                                                 cvkit_format(),    lytro_format(),      hci_hdf5_format()};
  return all;
}

const std::vector<std::string_view>& output_format_names() {
  static const std::vector<std::string_view> names = format_names(true);
  return names;
}

const LightFieldFormat& find_format(std::string_view name, std::string_view flag) {
  return format_named(name, flag, format_names(false));
}

const LightFieldFormat& find_output_format(std::string_view name, std::string_view flag) {
  const LightFieldFormat& format = format_named(name, flag, output_format_names());
  if (format.write == nullptr)
    throw usage_error(std::string(flag), fmt::format("the format {} can only be read", name),
                      std::string(format.written_instead));
  return format;
}

}  // namespace lippmann
