#include "bench/paper_summary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/paper_tables.hpp"

namespace lippmann::bench {
namespace {

Reproduced figures_of(const ReuseRun& run) {
  return {run.scene, run.keyframes, run.saving(), run.mean_psnr(), papers_saving(run.scene), papers_psnr_db(run.scene)};
}

/// Returns whether `b` reproduces the paper better than `a`. Runs that save as much as the paper come first, the shortest
/// key frame interval before longer ones. Runs that save less follow, the largest saving before smaller ones.
bool is_better(const Reproduced& b, const Reproduced& a) {
  const auto saves_enough = [](const Reproduced& r) { return r.paper_saving && r.saving >= *r.paper_saving; };
  if (saves_enough(a) != saves_enough(b)) return saves_enough(b);
  return saves_enough(a) ? b.keyframes < a.keyframes : b.saving > a.saving;
}

std::string percent(const std::optional<double>& share) { return share ? fmt::format("{:.1f} %", 100.0 * *share) : "-"; }
std::string number(const std::optional<double>& value, const char* without) {
  return value && std::isfinite(*value) ? fmt::format("{:.2f}", *value) : without;
}

}  // namespace

std::string Reproduced::verdict() const {
  if (!paper_saving) return "not in the paper";
  const bool near_enough = !paper_psnr_db || (psnr_db && *psnr_db >= *paper_psnr_db);
  return saving >= *paper_saving && near_enough ? "yes" : "no";
}

std::vector<Reproduced> reproduced_figures(const std::vector<ReuseRun>& runs) {
  std::vector<Reproduced> rows;
  for (const ReuseRun& run : runs) {
    if (run.method != "forward") continue;
    const Reproduced figures = figures_of(run);
    if (rows.empty() || rows.back().scene != run.scene)
      rows.push_back(figures);
    else if (is_better(figures, rows.back()))
      rows.back() = figures;
  }
  return rows;
}

std::string reproduced_text(const std::vector<Reproduced>& rows) {
  const auto in_paper = std::count_if(rows.begin(), rows.end(), [](const Reproduced& r) { return r.paper_saving.has_value(); });
  const auto reproduced = std::count_if(rows.begin(), rows.end(), [](const Reproduced& r) { return r.verdict() == "yes"; });
  std::string text = fmt::format(
      "Reproduced: {} of {} animations of the paper. Reproduced means: interpolation saves at least the share of tracing time "
      "that the paper reports, at the paper's PSNR or better where it reports one.\n\n"
      "scene               K   saved  paper saved    PSNR  paper PSNR  reproduced\n",
      reproduced, in_paper);
  for (const Reproduced& row : rows)
    text += fmt::format("{:18} {:2} {:>7} {:>12} {:>7} {:>11}  {}\n", row.scene, row.keyframes, percent(row.saving),
                        percent(row.paper_saving), number(row.psnr_db, "-"), number(row.paper_psnr_db, "-"), row.verdict());
  return text;
}

std::string reproduced_csv(const std::vector<Reproduced>& rows) {
  const auto share = [](const std::optional<double>& value) { return value ? fmt::format("{:.4f}", *value) : std::string(); };
  std::string text = "scene,keyframes,saving,paper_saving,psnr_db,paper_psnr_db,reproduced\n";
  for (const Reproduced& row : rows)
    text += fmt::format("{},{},{},{},{},{},{}\n", row.scene, row.keyframes, share(row.saving), share(row.paper_saving),
                        number(row.psnr_db, ""), number(row.paper_psnr_db, ""), row.verdict());
  return text;
}

}  // namespace lippmann::bench
