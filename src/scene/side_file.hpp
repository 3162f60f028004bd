// Finds the files beside a scene file that it refers to: inside the scene's own folder and nowhere else.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lippmann {

/// Where a file is that a scene in `folder` (empty: the current one) calls `name`. Throws Error at `where` for absolute names,
/// names with `..` and links that lead outside. Names are judged before links are followed, so that what is refused does not
/// depend on the disk. The file need not exist.
std::filesystem::path side_file(const std::filesystem::path& folder, std::string_view name, const std::string& where);

}  // namespace lippmann
