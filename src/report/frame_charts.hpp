// Charts of the frames of renders: quality, origin of pixels, time and rays.
#pragma once

#include <string>
#include <vector>

#include "report/chart.hpp"
#include "report/render_figures.hpp"

namespace lippmann {

/// PSNR in dB, the mean over the frames of the paper's teapot: Eljdid, Aggoun, Youssef, "Enhanced Techniques 3D Integral Images
/// Video Computer Generated".
inline constexpr double kPaperPsnrDb = 34.5;

/// Returns the estimated PSNR and its bounds, the requested minimum, and the paper's figure if frames were interpolated.
Chart psnr_chart(const RenderFigures& render);
/// Returns the share of pixels by Origin, in percent, without origins that no frame has.
Chart origin_chart(const RenderFigures& render);
/// Returns the CPU seconds of the frames, with fully traced frames as a separate series.
Chart time_chart(const RenderFigures& render);
/// Returns the CPU time saved, in percent of a fully traced frame, for frames that were not fully traced.
Chart saving_chart(const RenderFigures& render);
/// Returns rays per pixel by kind, or millions of rays if the frame size is unknown.
Chart ray_chart(const RenderFigures& render);

// Charts of several renders with one line each, over all frames of any render. names: one per render.
Chart psnr_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
Chart time_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
/// Returns the CPU time saved, in percent of the same frame of the first render.
Chart saving_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);

/// Returns the minimum PSNR that the settings request.
std::optional<double> wanted_psnr_db(const RenderFigures& render);
/// Returns the PSNR that quality is judged by: the lower bound, or else the estimate. None if the frame is exact or has no
/// estimate.
std::optional<double> sure_psnr_db(const FrameReport& frame);

}  // namespace lippmann
