// Charts of the frames of renders: quality, origin of pixels, time and rays.
#pragma once

#include <string>
#include <vector>

#include "report/chart.hpp"
#include "report/render_figures.hpp"

namespace lippmann {

/// The PSNR in dB that a paper reports, the mean over the frames of its teapot: Eljdid, Aggoun, Youssef, "Enhanced Techniques
/// 3D Integral Images Video Computer Generated".
inline constexpr double kPaperPsnrDb = 34.5;

/// Returns a chart of the estimated PSNR and its bounds, with the requested minimum and, if frames were interpolated, the
/// figure of the paper (kPaperPsnrDb).
Chart psnr_chart(const RenderFigures& render);
/// Returns a chart of the shares of pixels by Origin, in percent. Origins that no frame has are left out.
Chart origin_chart(const RenderFigures& render);
/// Returns a chart of the CPU seconds of the frames. Fully traced frames are a series of their own.
Chart time_chart(const RenderFigures& render);
/// Returns a chart of the CPU time saved, in percent of that of a fully traced frame, for frames that were not fully traced.
Chart saving_chart(const RenderFigures& render);
/// Returns a chart of the rays per pixel by kind, or of millions of rays if the frame size is unknown.
Chart ray_chart(const RenderFigures& render);

// The comparison charts have one line per render, over all frames that any render has. names: one per render.
Chart psnr_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
Chart time_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
/// Returns a chart of the CPU time saved, in percent of that of the same frame in the first render.
Chart saving_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);

/// Returns the minimum PSNR that the settings request; none if they request none.
std::optional<double> wanted_psnr_db(const RenderFigures& render);
/// Returns the PSNR with which a frame is judged: the lower bound of the estimate or, without one, the estimate. None if the
/// frame is exact or has no estimate.
std::optional<double> sure_psnr_db(const FrameReport& frame);

}  // namespace lippmann
