#include "lippmann/layout/formats.hpp"

#include <fmt/format.h>

#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

const std::vector<LightFieldFormat>& light_field_formats() {
  static const std::vector<LightFieldFormat> all{integral_format(), quilt_format(),      views_format(),   hci_format(),
                                                 stanford_format(), jpeg_pleno_format(), eslf_format(),    plenoptic_format(),
                                                 miv_format(),      nerf_format(),       colmap_format(),  llff_format(),
                                                 stereo_format(),   quad_format(),       rgbd_format(),    native_format(),
                                                 cvkit_format(),    lytro_format(),      hci_hdf5_format()};
  return all;
}

const LightFieldFormat& find_format(std::string_view name, std::string_view flag) {
  std::string known;
  std::vector<std::string_view> names;
  for (const LightFieldFormat& format : light_field_formats()) {
    if (format.name == name) return format;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", format.name);
    names.push_back(format.name);
  }
  throw usage_error(std::string(flag), fmt::format("unknown format '{}'{}", name, did_you_mean(name, names)), known);
}

}  // namespace lippmann
