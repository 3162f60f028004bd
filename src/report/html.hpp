// Text of pages in HTML: names of foreign origin as they are safe within it, and tables.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

/// Fit to stand between tags and in quoted attributes; bytes that are no UTF-8 become U+FFFD, control characters spaces.
std::string escaped(std::string_view text);

/// Data for the page's script: an element that is not shown and cannot run.
std::string data_html(const nlohmann::ordered_json& data);

/// A cell is HTML already. Rows may be shorter than the head.
struct HtmlTable {
  std::vector<std::string> head = {};
  std::vector<std::vector<std::string>> rows = {};
  std::string style = {};  ///< classes
};

/// Within a box that scrolls, so that a narrow window shows all of it. The first cell of a row is its heading.
std::string table_html(const HtmlTable& table);

/// A list of sentences, which are plain text; empty where there are none.
std::string sentences_html(const std::vector<std::string>& sentences);

}  // namespace lippmann
