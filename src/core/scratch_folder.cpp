#include "core/scratch_folder.hpp"

#include <string>
#include <system_error>

#include "core/platform.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

ScratchFolder::ScratchFolder() {
  std::error_code problem;
  const std::filesystem::path place = std::filesystem::temp_directory_path(problem);
  if (!problem) path_ = platform::make_unique_folder(place / "lippmann-", problem);
  if (problem)
    throw Error(place.empty() ? "TMPDIR" : place.string(), "cannot create a temporary folder: " + problem.message(),
                "a TMPDIR that can be written");
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace lippmann
