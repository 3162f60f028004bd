#include "report/html.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/json_text.hpp"

namespace lippmann {
namespace {

/// Returns valid UTF-8. The JSON writer replaces invalid bytes, and the parser removes the writer's escapes.
std::string as_utf8(std::string_view text) {
  const std::string json = json_to_text(nlohmann::ordered_json(std::string(text)), -1);
  return json_from_text(json).get<std::string>();
}

std::string_view escape_of(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

std::string cells_html(const std::vector<std::string>& cells, std::string_view first, std::string_view other) {
  std::string html;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string_view tag = i == 0 ? first : other;
    html += fmt::format("<{}>{}</{}>", tag, cells[i], tag.substr(0, 2));
  }
  return html;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : as_utf8(text)) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    if (const std::string_view escape = escape_of(c); !escape.empty())
      html += escape;
    else
      html += is_control ? ' ' : c;
  }
  return html;
}

std::string data_html(const nlohmann::ordered_json& data) {
  std::string html = "<script type=\"application/json\">";
  for (const char c : json_to_text(data, -1))  // in JSON, `<` occurs only in strings
    if (c == '<')
      html += "\\u003c";
    else
      html += c;
  return html + "</script>";
}

std::string table_html(const HtmlTable& table) {
  std::string html = fmt::format("<div class=\"scroll\" tabindex=\"0\"><table class=\"{}\">", table.style);
  if (!table.head.empty())
    html += fmt::format("<thead><tr>{}</tr></thead>", cells_html(table.head, "th scope=\"col\"", "th scope=\"col\""));
  html += "<tbody>";
  for (const std::vector<std::string>& row : table.rows)
    html += fmt::format("<tr>{}</tr>\n", cells_html(row, "th scope=\"row\"", "td"));
  return html + "</tbody></table></div>\n";
}

std::string sentences_html(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  std::string html;
  for (const std::string& sentence : sentences) html += "<li>" + escaped(sentence) + "</li>";
  return "<ul class=\"missing\">" + html + "</ul>\n";
}

}  // namespace lippmann
