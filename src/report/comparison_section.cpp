#include "report/comparison_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/figure_text.hpp"
#include "report/frame_charts.hpp"
#include "report/frame_origins.hpp"
#include "report/html.hpp"
#include "report/render_summary.hpp"

namespace lippmann {
namespace {

std::string saving_over_first(const RenderFigures& first, const RenderFigures& render) {
  const std::optional<double> mean = cpu_seconds_a_frame(render);
  return mean ? percent_text(saving(*mean, cpu_seconds_a_frame(first))) : kNotKnown;
}

std::vector<int> frame_numbers(const RenderFigures& render) {
  std::vector<int> numbers;
  for (const FrameReport& frame : render.frames) numbers.push_back(frame.frame);
  return numbers;
}

std::vector<std::string> caveats(const std::vector<RenderFigures>& renders) {
  const RenderFigures& first = renders.front();
  const auto differs = [&](const auto& of) {
    return std::any_of(renders.begin(), renders.end(), [&](const RenderFigures& render) { return of(render) != of(first); });
  };
  std::vector<std::string> sentences;
  if (differs([](const RenderFigures& render) { return render.scene; })) sentences.emplace_back("The scenes differ.");
  if (differs(frame_numbers)) sentences.emplace_back("The frames differ: each mean is over the frames of that render.");
  if (differs([](const RenderFigures& render) { return render.pixels; }))
    sentences.emplace_back("The pictures differ in size.");
  if (differs([](const RenderFigures& render) { return render.runs.empty() ? "" : render.runs.front().host; }))
    sentences.emplace_back("The machines differ or are unknown: times are not comparable.");
  return sentences;
}

}  // namespace

std::string comparison_section(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names) {
  HtmlTable table{{""}, {}, "compare"};
  for (const std::string& name : names) table.head.push_back(escaped(name));
  table.rows.push_back({"reuse"});
  for (const RenderFigures& render : renders) table.rows[0].push_back(escaped(render.reuse.empty() ? kNotKnown : render.reuse));
  const std::vector<SummaryFigure> first = render_summary(renders.front());
  for (std::size_t i = 0; i < first.size(); ++i) {
    std::vector<std::string> row{escaped(first[i].name)};
    for (const RenderFigures& render : renders) {
      const SummaryFigure figure = render_summary(render)[i];
      row.push_back(fmt::format("{}<small>{}</small>", escaped(figure.value), escaped(figure.why)));
    }
    table.rows.push_back(std::move(row));
  }
  std::vector<std::string> beside{fmt::format("CPU time saved, compared with {}", escaped(names.front()))};
  for (std::size_t i = 0; i < renders.size(); ++i)
    beside.push_back(i == 0 ? "" : saving_over_first(renders.front(), renders[i]));
  table.rows.push_back(std::move(beside));
  return fmt::format(
      "<section><h2>Side by side</h2>{}{}{}</section>\n", sentences_html(caveats(renders)), table_html(table),
      charts_html({psnr_comparison(renders, names), time_comparison(renders, names), saving_comparison(renders, names)}));
}

}  // namespace lippmann
