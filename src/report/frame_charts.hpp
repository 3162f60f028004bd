// Charts of the frames of renders: quality, origin of pixels, time and rays.
#pragma once

#include <string>
#include <vector>

#include "report/chart.hpp"
#include "report/render_figures.hpp"

namespace lippmann {

/// The PSNR in dB that a paper reports as the mean over the frames of its teapot: Eljdid, Aggoun, Youssef, "Enhanced Techniques
/// 3D Integral Images Video Computer Generated".
inline constexpr double kPaperPsnrDb = 34.5;

/// Returns a chart of the estimated PSNR and its bounds. Lines mark the requested minimum and, for interpolated frames,
/// kPaperPsnrDb.
Chart psnr_chart(const RenderFigures& render);
/// Returns a chart of the percentage of pixels of each Origin. Origins that no frame has are left out.
Chart origin_chart(const RenderFigures& render);
/// Returns a chart of the CPU seconds of the frames. Fully traced frames form a separate series.
Chart time_chart(const RenderFigures& render);
/// Returns a chart of the CPU time saved in frames that were not fully traced, in percent of a fully traced frame.
Chart saving_chart(const RenderFigures& render);
/// Returns a chart of the rays per pixel, one series per kind of ray. If the frame size is unknown, shows millions of rays.
Chart ray_chart(const RenderFigures& render);

// The following comparison charts have one line per render, over all frames that any render has. `names` has one entry per
// render.
Chart psnr_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
Chart time_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
/// Returns a chart of the CPU time saved, in percent of the same frame in the first render.
Chart saving_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);

/// Returns the minimum PSNR that the settings request. Returns nullopt if they request none.
std::optional<double> wanted_psnr_db(const RenderFigures& render);
/// Returns the PSNR by which a frame is judged: the lower bound of the estimate, or the estimate if it has no bound. Returns
/// nullopt if the frame is exact or has no estimate.
std::optional<double> sure_psnr_db(const FrameReport& frame);

}  // namespace lippmann
