// The files of the page that `lippmann view` serves, built by web/ and embedded by cmake/embed_page.cmake.
#pragma once

#include <span>
#include <string_view>

namespace lippmann {

struct PageFile {
  std::string_view name, type, text;
};

/// index.html is first.
std::span<const PageFile> page_files();

}  // namespace lippmann
