#include "apps/lippmann/build_facts.hpp"

#include <fmt/format.h>

#include "align/align_module_file.hpp"
#include "core/task_library.hpp"
#include "device/embree_version.hpp"
#include "distribute/ranks_module_file.hpp"
#include "video/video_module_file.hpp"

namespace lippmann::app {
namespace {

const char* word_for(bool installed) { return installed ? "installed" : "not installed"; }

}  // namespace

std::string build_facts() {
  std::string facts = fmt::format("{:<9}{}\n", "commit", LIPPMANN_COMMIT);
  facts += fmt::format("{:<9}{}, {}\n", "compiler", LIPPMANN_COMPILER, LIPPMANN_BUILD_TYPE);
  facts += fmt::format("{:<9}{}\n", "Embree", embree_version());
  facts += fmt::format("{:<9}{}\n", "oneTBB", task_library_version());
  facts += fmt::format("{:<9}{}\n", "pictures", LIPPMANN_PICTURE_LIBRARIES);
  facts += fmt::format("{:<9}module {}, for FFmpeg (libavcodec {})\n", "videos", word_for(is_video_module_installed()),
                       LIPPMANN_LIBAVCODEC);
  facts += fmt::format("{:<9}module {}, for OpenCV\n", "align", word_for(is_align_module_installed()));
  return facts + fmt::format("{:<9}module {}", "MPI", word_for(is_ranks_module_installed()));
}

}  // namespace lippmann::app
