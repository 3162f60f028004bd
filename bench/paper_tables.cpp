#include "bench/paper_tables.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

namespace lippmann::bench {
namespace {

// Figures of the paper: Eljdid, Aggoun, Youssef, "Enhanced Techniques 3D Integral Images Video Computer Generated".
struct PaperFrame {
  int frame;
  double mean_mse, psnr;
};
constexpr PaperFrame kTable1[] = {{103, 21.4394, 34.8187}, {104, 24.7497, 34.1951}, {105, 21.6736, 34.7715},
                                  {106, 25.3311, 34.0943}, {107, 22.0668, 34.6934}, {108, 25.7705, 34.0196},
                                  {109, 22.8951, 34.5334}};

constexpr double kPaperMeanPsnr = 34.52;

struct PaperAnimation {
  std::string_view scene;
  double traced, interpolated;  ///< seconds for the whole animation
};
constexpr PaperAnimation kTable2[] = {
    {"teapot", 1836, 520}, {"room", 1268, 496}, {"small-balls", 842, 189}, {"primitives", 1024, 333}, {"tree", 9017, 3672}};

struct PaperStyles {
  std::string_view scene;
  double vertical, horizontal;
};
constexpr PaperStyles kTable3[] = {{"teapot", 0.046, 0.046},     {"room", 0.016, 0.016}, {"small-balls", 0.016, 0.016},
                                   {"primitives", 0.015, 0.016}, {"tree", 0.156, 0.230}, {"gears", 0.062, 0.078}};

std::string papers_name(const std::string& scene) {
  constexpr std::string_view kTachyon = "tachyon ";
  const std::string name = scene.starts_with(kTachyon) ? scene.substr(kTachyon.size()) : scene;
  return name == "smallballs" ? "small-balls" : name;
}

template <class Row, std::size_t N>
const Row* find(const Row (&table)[N], const std::string& scene) {
  for (const Row& row : table)
    if (row.scene == papers_name(scene)) return &row;
  return nullptr;
}

std::string decibels(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:.2f}", *value) : std::string("-");
}

std::string line_of(const ReuseFrame& frame, int keyframes) {
  const PaperFrame* paper = nullptr;
  for (const PaperFrame& row : kTable1)
    if (row.frame == frame.frame) paper = &row;
  const ChannelErrors &mse = frame.likeness.mse, &rmse = frame.likeness.rmse;
  std::string line = fmt::format("{:5} {:2}", frame.frame, keyframes);
  if (frame.key)
    line += fmt::format(" {:>56}", "a key frame: exact");
  else
    line += fmt::format(" {:8.2f} {:8.2f} {:8.2f} {:8.2f} {:6.2f} {:>6} {:>6}", mse.r, mse.g, mse.b, mse.mean, rmse.mean,
                        decibels(frame.likeness.psnr_db), decibels(frame.moving_psnr));
  line += fmt::format(" {:>6}", frame.key ? "" : decibels(frame.blend_psnr));
  if (paper) line += fmt::format("   {:8.2f} {:6.2f}", paper->mean_mse, paper->psnr);
  return line + '\n';
}

std::string scene_of_table_1(const std::vector<ReuseRun>& runs) {
  for (const std::string_view name : {"tachyon teapot", "teapot"})
    for (const ReuseRun& run : runs)
      if (run.scene == name) return run.scene;
  return runs.front().scene;
}

/// Table 1 lists the frames of the paper's table if the run contains all of them, and otherwise the first nine frames.
bool is_listed(const ReuseRun& run, const ReuseFrame& frame) {
  const int from = std::begin(kTable1)->frame, to = std::prev(std::end(kTable1))->frame;
  const bool has_them = run.frames.front().frame <= from && run.frames.back().frame >= to;
  return has_them ? frame.frame >= from && frame.frame <= to : frame.frame < run.frames.front().frame + 9;
}

}  // namespace

std::optional<double> papers_saving(const std::string& scene) {
  const PaperAnimation* paper = find(kTable2, scene);
  return paper ? std::optional(1.0 - paper->interpolated / paper->traced) : std::nullopt;
}

std::optional<double> papers_psnr_db(const std::string& scene) {
  return papers_name(scene) == "teapot" ? std::optional(kPaperMeanPsnr) : std::nullopt;
}

std::string table_1(const std::vector<ReuseRun>& runs) {
  std::string text =
      "Table 1. Interpolated frames against traced ones: MSE of R, G, B and their mean, RMSE, PSNR (moving: over the pixels "
      "that\n"
      "differ between the key frames around; blend: of the plain mean of these, without motion). The columns that the paper "
      "calls\n"
      "RMSE are mean squared errors: 10 log10(255^2 / 21.4394) is its 34.82 dB of frame 103.\n";
  const std::string scene = scene_of_table_1(runs);
  text += fmt::format("\n{}\nframe  K    MSE R    MSE G    MSE B     mean   RMSE   PSNR moving  blend   paper's: MSE   PSNR\n",
                      scene);
  for (const ReuseRun& run : runs)
    for (const ReuseFrame& frame : run.frames)
      if (run.scene == scene && run.method == "forward" && is_listed(run, frame)) text += line_of(frame, run.keyframes);
  return text;
}

std::string table_2(const std::vector<ReuseRun>& runs) {
  std::string text =
      "Table 2. Whole animations, every K-th frame traced: CPU milliseconds per frame of full tracing (our own fastest) and of "
      "a\n"
      "frame in between, what is saved per frame in between and in all, key frames included; mean PSNR and SSIM of the frames "
      "in\n"
      "between. h: by halving, made frames being sources too. The paper gives no interval; its baseline was a modified "
      "Tachyon.\n\n"
      "scene               K frames traced between  saved  in all   PSNR moving  blend   SSIM missed   paper saved\n";
  for (const ReuseRun& run : runs) {
    const double frames = static_cast<double>(run.frames.size()), traced = run.traced_seconds() / frames;
    text += fmt::format("{:18} {:2}{} {:5} {:6.1f} {:7.2f} {:5.1f} % {:5.1f} % {:>6} {:>6} {:>6} {:.4f} {:4.2f} %", run.scene,
                        run.keyframes, run.method == "forward" ? ' ' : 'h', run.frames.size(), 1e3 * traced,
                        1e3 * traced * (1.0 - run.saving_in_between()), 100.0 * run.saving_in_between(), 100.0 * run.saving(),
                        decibels(run.mean_psnr()), decibels(run.mean_moving_psnr()), decibels(run.mean_blend_psnr()),
                        run.mean_ssim(), 100.0 * run.missed_share());
    if (const PaperAnimation* paper = find(kTable2, run.scene))
      text += fmt::format("   {:.0f} %", 100.0 * (1.0 - paper->interpolated / paper->traced));
    text += '\n';
  }
  return text;
}

std::string table_3(const std::vector<StyleRow>& rows) {
  std::string text =
      "Table 3. Pixel-tracing styles: CPU milliseconds for the first cylindrical lens, horizontal (row by row) and vertical "
      "(down\n"
      "the lens), and for the whole frame also in tiles of one directional view.\n\n"
      "scene        lens: horizontal vertical  ratio   frame: horizontal vertical  views  ratio   paper's ratio\n";
  for (const StyleRow& row : rows) {
    text += fmt::format("{:11} {:17.3f} {:8.3f} {:6.2f} {:19.1f} {:8.1f} {:6.1f} {:6.2f}", row.scene, row.horizontal_lens_ms,
                        row.vertical_lens_ms, row.horizontal_lens_ms / row.vertical_lens_ms, row.horizontal_ms, row.vertical_ms,
                        row.view_ms, row.horizontal_ms / row.vertical_ms);
    if (const PaperStyles* paper = find(kTable3, row.scene))
      text += fmt::format("   {:.2f}", paper->horizontal / paper->vertical);
    text += '\n';
  }
  return text;
}

}  // namespace lippmann::bench
