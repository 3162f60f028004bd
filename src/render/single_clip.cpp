#include "render/single_clip.hpp"

#include <filesystem>

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::string beside(const fs::path& video) {
  return (video.parent_path() / (video.stem().string() + "_single" + video.extension().string())).string();
}

Extent<int> picture_size(const Optics& optics) {
  const auto* views = std::get_if<MultiView>(&optics.model);
  const int columns = views ? views->columns : 1, rows = views ? views->rows : 1;
  return {optics.panel.width / columns, optics.panel.height / rows};
}

}  // namespace

RenderParams single_clip(const RenderParams& params, const Optics& optics) {
  const RenderParams defaults;
  RenderParams single = params;
  single.optics = OpticsKind::kSingle;
  single.packing = defaults.packing, single.lenses = {}, single.lens_pixels = {}, single.views = {};
  single.camera_grid = false, single.slant_deg = 0.0f, single.fit_depth.reset();
  single.crosstalk_px.reset(), single.precompensate = false, single.angular_filter.reset();
  single.size = params.display.empty() ? picture_size(optics) : Extent<int>{};
  single.layout.reset(), single.mirror = false, single.pseudoscopic = false, single.quilt = {};
  single.output = (fs::path(output_folder(params)) / "single").string();
  for (std::string& video : single.video) video = beside(video);
  return single;
}

}  // namespace lippmann
