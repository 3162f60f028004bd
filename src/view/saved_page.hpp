// Saves the page with its light fields: in a folder, for any web server or for opening from disk, or in one file.
//
// Pages opened from disk cannot read the files beside them, but can run scripts. Each image is therefore saved as a script that
// passes the image's bytes to the page in base64.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "view/page_field.hpp"

namespace lippmann {

struct SavedPage {
  std::filesystem::path index;
  std::uintmax_t bytes = 0;
  std::vector<std::filesystem::path> files = {};
};

/// Makes the folder if necessary, and replaces a page saved there before. Throws Error naming a file, also if the folder
/// contains another page. If context.cancelled is set, stops without writing index.html.
SavedPage save_page(const std::vector<std::unique_ptr<PageField>>& fields, const std::filesystem::path& folder,
                    const Context& context);

/// Throws Error above 1 GB, because browsers cannot open such files. If context.cancelled is set, returns an empty string.
std::string page_as_file(const std::vector<std::unique_ptr<PageField>>& fields, const Context& context);

/// Throws Error naming the file, also if it exists and is not a saved page.
SavedPage save_page_file(const std::vector<std::unique_ptr<PageField>>& fields, const std::filesystem::path& file,
                         const Context& context);

SavedPage save_page(const std::filesystem::path& in, const std::filesystem::path& folder, const Context& context);

}  // namespace lippmann
