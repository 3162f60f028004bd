// The page with its light fields in a folder that any web server serves, and that opens from a disk too; or in one file.
//
// Pages that are opened from a disk may not read files beside them, only run scripts: so each picture is a script that hands
// its bytes, in base 64, to the page. That takes a third more bytes, and one way serves both (docs/lab/decisions/0024).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "view/page_field.hpp"

namespace lippmann {

struct SavedPage {
  std::filesystem::path index;  ///< what to open
  std::uintmax_t bytes = 0;     ///< all files together
  std::vector<std::filesystem::path> files = {};
};

/// Makes the folder; files of a page that was saved there before are replaced. Throws Error naming a file, also where the
/// folder holds another page. Stops between frames when context.cancelled is set, and leaves no index.html then.
SavedPage save_page(const std::vector<std::unique_ptr<PageField>>& fields, const std::filesystem::path& folder,
                    const Context& context);

/// The page in one file: everything is in the document. Throws Error where it would have more than 1 GB, which browsers do not
/// open. Stops between frames when context.cancelled is set, and is empty then.
std::string page_as_file(const std::vector<std::unique_ptr<PageField>>& fields, const Context& context);

/// page_as_file, written. Throws Error naming the file, also where it exists and is no such page.
SavedPage save_page_file(const std::vector<std::unique_ptr<PageField>>& fields, const std::filesystem::path& file,
                         const Context& context);

/// The same of one light field: a finished render's folder, say.
SavedPage save_page(const std::filesystem::path& in, const std::filesystem::path& folder, const Context& context);

}  // namespace lippmann
