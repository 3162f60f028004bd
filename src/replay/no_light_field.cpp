#include "replay/no_light_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "core/folder_entries.hpp"
#include "formats/frame_names.hpp"
#include "formats/light_field_source.hpp"
#include "lippmann/core/error.hpp"
#include "video/video_reader.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Entries = std::vector<fs::directory_entry>;

constexpr const char* kFramesOrViews =
    "frame_0000.png, frame_0001.png, ..., or a folder of views that `lippmann convert` reads";

std::string first_name(const Entries& entries, bool (*predicate)(const fs::path&)) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return predicate(entry.path()); });
  return found == entries.end() ? std::string() : found->path().filename().string();
}

void refuse_folder(const fs::path& folder) {
  const Entries entries = entries_of(folder);
  if (entries.empty()) throw Error(folder.string(), "is an empty folder", kFramesOrViews);
  if (const std::string video = first_name(entries, is_video_name); !video.empty())
    throw Error(folder.string(), fmt::format("it has only videos ({}), no frames or views", video),
                "the folder of frames that they were made of");
  if (fs::exists(folder / "job.toml"))
    throw Error(
        folder.string(), "the job in it has not been rendered",
        fmt::format("`lippmann render {0}` first, or `lippmann view {0}` to set it up", (folder / "job.toml").string()));
  const auto is_picture = [](const fs::directory_entry& entry) { return is_picture_name(entry.path()); };
  const std::string picture = first_name(entries, is_picture_name);
  if (std::count_if(entries.begin(), entries.end(), is_picture) == 1)
    throw Error(folder.string(), fmt::format("contains only one picture, {}", picture),
                "two or more pictures of one size, which are the views");
  if (!picture.empty())
    throw Error(
        folder.string(), fmt::format("its pictures, such as {}, are not named as frames or views", picture),
        fmt::format("{}; one of these pictures; or the format views, which reads all pictures in the order of their names",
                    kFramesOrViews));
}

}  // namespace

void require_light_field(const fs::path& in) {
  std::error_code ignored;
  if (!fs::exists(in, ignored)) throw Error(in.string(), "there is no such file or folder");
  if (!fs::is_directory(in, ignored)) {
    if (is_video_name(in))
      throw Error(in.string(), "only `lippmann convert` reads views from a video",
                  "`lippmann convert` to views, or the folder of frames that the video was made of");
    return;
  }
  if (light_field_frames(in, "").empty() && !is_light_field_folder(in)) refuse_folder(in);
}

void require_picture_name(const fs::path& file) {
  if (!is_picture_name(file))
    throw Error(file.string(), "is not a picture", "a picture, a folder of frames or views, or a scene");
}

}  // namespace lippmann
