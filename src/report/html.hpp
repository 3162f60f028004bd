// Builds HTML: escapes untrusted text and formats tables.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

/// Escapes text for elements and quoted attributes. Invalid UTF-8 becomes U+FFFD, control characters become spaces.
std::string escaped(std::string_view text);

/// Returns an invisible element with data for the page's script. The data cannot run as a script.
std::string data_html(const nlohmann::ordered_json& data);

struct HtmlTable {
  std::vector<std::string> head = {};
  std::vector<std::vector<std::string>> rows = {};
  std::string style = {};
};

/// Returns the table in a box that scrolls in narrow windows. The first cell of each row is its heading.
std::string table_html(const HtmlTable& table);

std::string sentences_html(const std::vector<std::string>& sentences);

}  // namespace lippmann
