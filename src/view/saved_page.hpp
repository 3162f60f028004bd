// Saves the page with its light fields: in a folder, for any web server or for opening from disk, or in one file.
//
// Pages opened from disk cannot read the files beside them, but can run scripts. Each image is therefore saved as a script that
// passes the image's bytes to the page in base64.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "view/page_field.hpp"

namespace lippmann {

/// Receives the label of each frame whose pictures are saved.
using FrameSaved = std::function<void(const std::string& label)>;

struct SavedPage {
  std::filesystem::path index;
  std::uintmax_t bytes = 0;
  std::vector<std::filesystem::path> files = {};
};

/// Makes the folder if necessary, and replaces a page saved there before. Throws Error naming a file if saving fails, or if the
/// folder contains any other page. If context.cancelled is set, stops without writing index.html.
SavedPage save_page(const std::vector<std::unique_ptr<PageField>>& fields, const std::filesystem::path& folder,
                    const Context& context, const FrameSaved& saved = {});

/// Returns the page with all data as one document. Throws Error if it exceeds 1 GB, because browsers cannot open such files. If
/// context.cancelled is set, stops between frames and returns an empty string.
std::string page_as_file(const std::vector<std::unique_ptr<PageField>>& fields, const Context& context,
                         const FrameSaved& saved = {});

/// Throws Error naming the file if saving fails, or if the file exists and is not a saved page.
SavedPage save_page_file(const std::vector<std::unique_ptr<PageField>>& fields, const std::filesystem::path& file,
                         const Context& context, const FrameSaved& saved = {});

SavedPage save_page(const std::filesystem::path& in, const std::filesystem::path& folder, const Context& context);

}  // namespace lippmann
