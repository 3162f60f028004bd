#include "replay/converted_frames.hpp"

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/json_text.hpp"
#include "lippmann/core/error.hpp"
#include "optics/optics_json.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

void write_report(const fs::path& path, const RenderedFrames& frames, const PictureConversion& conversion) {
  nlohmann::ordered_json made{{"from", conversion.in.string()}};
  made.update(conversion.made());
  const nlohmann::ordered_json report{
      {"optics", optics_json(conversion.optics)}, {"frames_per_second", frames.frames_per_second}, {"made", std::move(made)}};
  const std::string text = json_to_text(report) + "\n";
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

void make_other_folder(const fs::path& folder, const fs::path& in) {
  make_folder(folder);
  std::error_code problem;
  if (fs::equivalent(folder, in, problem)) throw usage_error("OUT", "the results would overwrite the input", "another folder");
}

}  // namespace

std::vector<fs::path> convert_frames(const RenderedFrames& frames, const PictureConversion& conversion,
                                     const Context& context) {
  const fs::path from = frames.files.front().parent_path();
  make_other_folder(conversion.out, from.empty() ? "." : from);
  std::vector<fs::path> written;
  for (const fs::path& file : frames.files) {
    if (context.cancelled) return written;
    const Picture picture = read_panel_picture(frames, file);
    written.push_back(conversion.out / file.filename());
    if (!std::holds_alternative<Image>(picture)) written.back().replace_extension(".png");
    write_picture(written.back(), conversion.convert(picture));
  }
  written.push_back(conversion.out / "report.json");
  write_report(written.back(), frames, conversion);
  return written;
}

}  // namespace lippmann
