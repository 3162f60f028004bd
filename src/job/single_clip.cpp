#include "job/single_clip.hpp"

#include <filesystem>

#include "folder/journal.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::string beside(const fs::path& video) {
  return (video.parent_path() / (video.stem().string() + "_single" + video.extension().string())).string();
}

Extent<int> extent_of_picture(const Optics& optics) {
  const ViewTiles tiles = view_tiles(optics).value_or(ViewTiles{});
  return {optics.panel.width / tiles.columns, optics.panel.height / tiles.rows};
}

}  // namespace

RenderParams single_clip(const RenderParams& params, const Optics& optics) {
  const RenderParams defaults;
  RenderParams single = params;
  single.optics.kind = OpticsKind::kSingle;
  single.optics.packing = defaults.optics.packing, single.optics.lenses = {}, single.optics.lens_pixels = {},
  single.optics.views = {};
  single.optics.camera_grid = false, single.optics.cone_ends = false, single.optics.slant_deg = 0.0f,
  single.optics.fit_depth.reset();
  single.optics.crosstalk_px.reset(), single.optics.precompensate = false, single.sampling.angular_filter.reset();
  single.optics.size = params.optics.display.empty() ? extent_of_picture(optics) : Extent<int>{};
  single.output.pictures.layout.reset(), single.output.pictures.to.clear(),
      single.output.pictures.mirror = false, single.output.pictures.pseudoscopic = false, single.output.pictures.quilt = {};
  single.strips = 1;  // a single view has too few rows for strips to pay off
  single.output.pictures.depth = {};
  single.output.pictures.stereo = {}, single.optics.ipd_mm.reset(), single.optics.screen_width_mm.reset();
  single.output.folder = (fs::path(output_folder(params)) / kSingleFolder).string();
  single.output.also.reset(), single.output.page = false;
  for (std::string& video : single.output.video) video = beside(video);
  return single;
}

}  // namespace lippmann
