// The files of the page that `lippmann view` shows, as web/ builds them; cmake/embed_page.cmake makes the source.
#pragma once

#include <span>
#include <string_view>

namespace lippmann {

struct PageFile {
  std::string_view name, type, text;
};

/// index.html first.
std::span<const PageFile> page_files();

}  // namespace lippmann
