#include "job/aov_params.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "job/test_pattern.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/kept_data.hpp"

namespace lippmann {

namespace {

void check_transparent(const RenderParams& params) {
  constexpr const char* kFlag = "--transparent";
  if (params.scene.name == kTestPattern)
    throw usage_error(kFlag, "the test pattern cannot be transparent", "a scene in place of the test pattern");
  if (!params.output.video.empty())
    throw usage_error(kFlag, "cannot be combined with --video: no video codec keeps alpha", "one of the two");
  if (params.output.pictures.layout == PictureLayout::kNative || params.output.pictures.layout == PictureLayout::kPrint)
    throw usage_error(kFlag, "pictures for panels and prints cannot store alpha", "--layout integral, quilt or views");
  if (params.optics.precompensate) throw usage_error(kFlag, "cannot be combined with --precompensate", "one of the two");
}

/// Returns whether `pictures.to` names a light-field format. It may also name a layout, or be empty.
bool is_light_field(const PictureParams& pictures) {
  constexpr std::array<std::string_view, 4> kLayouts{"integral", "quilt", "views", "native"};
  return !pictures.to.empty() && std::find(kLayouts.begin(), kLayouts.end(), pictures.to) == kLayouts.end();
}

/// Light-field formats store no layers except depth.
void check_light_field(const RenderParams& params) {
  const bool stores_depth = uses_depth(find_output_format(params.output.pictures.to, "to").name);
  for (const Aov layer : params.sampling.aov)
    if (layer != Aov::kDepth || !stores_depth)
      throw usage_error("aov", fmt::format("files of the format {} cannot store these layers", params.output.pictures.to),
                        stores_depth ? "depth alone, which is always written" : "a format with layers, such as `format` exr");
  if (params.sampling.transparent)
    throw usage_error("transparent", fmt::format("files of the format {} hold no alpha", params.output.pictures.to),
                      "`layout` quilt or views");
}

}  // namespace

void check_aovs(const RenderParams& params) {
  if (params.sampling.transparent) check_transparent(params);
  if (is_light_field(params.output.pictures)) check_light_field(params);
  if (!params.sampling.aov.empty() && params.scene.name == kTestPattern)
    throw usage_error("--aov", "the test pattern has no extra layers", "a scene in place of the test pattern");
}

}  // namespace lippmann
