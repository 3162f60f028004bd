// Charts of the frames of renders: quality, origin of pixels, time and rays.
#pragma once

#include <string>
#include <vector>

#include "report/chart.hpp"
#include "report/render_figures.hpp"

namespace lippmann {

/// Mean PSNR in dB over the frames of the teapot animation in Eljdid, Aggoun, Youssef, "Enhanced Techniques 3D Integral Images
/// Video Computer Generated".
inline constexpr double kPaperPsnrDb = 34.5;

/// The estimated PSNR and its bounds, with lines at the requested minimum and, for interpolated frames, at kPaperPsnrDb.
Chart psnr_chart(const RenderFigures& render);
Chart origin_chart(const RenderFigures& render);
Chart time_chart(const RenderFigures& render);
/// CPU time saved in frames that were not fully traced, in percent of the CPU time of a fully traced frame.
Chart saving_chart(const RenderFigures& render);
/// Rays per pixel by kind of ray, or millions of rays if the frame size is unknown.
Chart ray_chart(const RenderFigures& render);

// The following charts compare renders, with one line per render. `names`: names of the renders.
Chart psnr_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
Chart time_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
Chart saving_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);

std::optional<double> wanted_psnr_db(const RenderFigures& render);
/// Returns the lower bound of the estimated PSNR, or the estimate if it has no bound. Returns nullopt if the frame is exact or
/// has no estimate.
std::optional<double> sure_psnr_db(const FrameReport& frame);

}  // namespace lippmann
