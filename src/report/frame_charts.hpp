// Charts of renders' frames: quality, where pixels come from, time, rays.
#pragma once

#include <string>
#include <vector>

#include "report/chart.hpp"
#include "report/render_figures.hpp"

namespace lippmann {

/// dB, the mean over the frames of its teapot: Eljdid, Aggoun, Youssef, "Enhanced Techniques 3D Integral Images Video Computer
/// Generated".
inline constexpr double kPaperPsnrDb = 34.5;

/// PSNR as told and its bound, the floor that was asked for, and the paper's figure where frames were interpolated.
Chart psnr_chart(const RenderFigures& render);
/// Percent of the pixels by Origin; those that no frame has are left out.
Chart origin_chart(const RenderFigures& render);
/// CPU seconds of frames, those traced whole apart from the others.
Chart time_chart(const RenderFigures& render);
/// Percent of the CPU time of a frame traced whole; frames that were traced whole have none.
Chart saving_chart(const RenderFigures& render);
/// Rays a pixel by kind, or millions of them where the size of frames is not known.
Chart ray_chart(const RenderFigures& render);

// The same of several renders, one line each, over all frames that any of them has. `names`: one a render.
Chart psnr_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
Chart time_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);
/// Percent of the CPU time of the same frame of the first render.
Chart saving_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);

/// The floor on PSNR that the settings ask for.
std::optional<double> wanted_psnr_db(const RenderFigures& render);
/// By which quality is judged: the bound, or else the estimate; none: exact, or not estimated.
std::optional<double> sure_psnr_db(const FrameReport& frame);

}  // namespace lippmann
