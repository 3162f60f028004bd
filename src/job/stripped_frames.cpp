#include "job/stripped_frames.hpp"

#include "folder/strips.hpp"
#include "formats/frame_names.hpp"
#include "job/job_folder.hpp"

namespace lippmann {

StrippedFrames::StrippedFrames(const StripMaker& strips, RenderFolder& folder, const Settings& settings, RunProgress& progress,
                               const Context& context)
    : strips_(strips), folder_(folder), settings_(settings), progress_(progress), context_(context) {}

void StrippedFrames::make_strips(const std::vector<int>& parts) {
  take_strips(parts, folder_,
              {strips_.strips(), settings_.keeps_finished, [this](int frame, int strip) { return make_strip(frame, strip); }});
}

bool StrippedFrames::make_strip(int frame, int strip) {
  if (context_.cancelled) return false;
  const RenderedFrame rendered = strips_.make(frame, strip);
  if (context_.cancelled) return false;
  const FileRecords files = write_strip(folder_.path(), frame, strip, rendered.pictures);
  const StripNumber number{frame, strip, strips_.strips()};
  folder_.add_strip(number, rendered.report, files);
  made_.push_back({number, rendered.report});
  progress_.strip_written(rendered.report, files.begin()->second.bytes);
  return true;
}

RenderedFrame StrippedFrames::make(int frame) {
  if (!settings_.only_joins) make_strips(parts_of({frame}, strips_.strips()));
  return context_.cancelled ? RenderedFrame{} : join(frame);
}

RenderedFrame StrippedFrames::join(int frame) const {
  const std::vector<FrameReport> reports = finished_strips(folder_, frame, strips_.strips());
  RenderedFrame joined;
  joined.pictures.film = Image(settings_.film.x, settings_.film.y, 3);
  joined.pictures.aovs.wanted = settings_.wanted.wanted;
  for (std::size_t i = 0; i < kAovs; ++i)
    if (joined.pictures.aovs.wanted[i]) joined.pictures.aovs.allocate(static_cast<Aov>(i), settings_.film);
  std::vector<int> rows;
  for (int strip = 0; strip < strips_.strips(); ++strip) {
    const FilmRows of_strip = strips_.rows_of(strip);
    rows.push_back(of_strip.end - of_strip.first);
    read_strip(folder_.path() / strip_name(frame, strip), of_strip.first, rows.back(), joined.pictures);
  }
  joined.report = report_of_strips(reports, rows);
  return joined;
}

}  // namespace lippmann
