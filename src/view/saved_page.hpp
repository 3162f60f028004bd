// Saves the page with its light fields: in a folder, which can be put on any web server or opened from disk, or in one file.
//
// Pages opened from disk cannot read the files beside them, but they can run scripts. Each image is therefore saved as a script
// that passes the image's bytes to the page in base64. This adds a third to the size, but works on a server and from disk.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "view/page_field.hpp"

namespace lippmann {

struct SavedPage {
  std::filesystem::path index;  ///< the file to open in a browser
  std::uintmax_t bytes = 0;     ///< total size of all files
  std::vector<std::filesystem::path> files = {};
};

/// Saves the page to a folder, which is created if necessary. Replaces the files of a page saved there before. Throws Error
/// naming a file, also if the folder contains another page. If context.cancelled is set, stops between frames without writing
/// index.html.
SavedPage save_page(const std::vector<std::unique_ptr<PageField>>& fields, const std::filesystem::path& folder,
                    const Context& context);

/// Returns the page with all data as one document. Throws Error if it exceeds 1 GB, because browsers cannot open such files. If
/// context.cancelled is set, stops between frames and returns an empty string.
std::string page_as_file(const std::vector<std::unique_ptr<PageField>>& fields, const Context& context);

/// Writes page_as_file() to a file. Throws Error naming the file, also if it exists and is not a saved page.
SavedPage save_page_file(const std::vector<std::unique_ptr<PageField>>& fields, const std::filesystem::path& file,
                         const Context& context);

/// Saves the page of one light field, for example of a finished render.
SavedPage save_page(const std::filesystem::path& in, const std::filesystem::path& folder, const Context& context);

}  // namespace lippmann
