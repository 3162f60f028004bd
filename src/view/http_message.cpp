#include "view/http_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

namespace lippmann {
namespace {

/// Pages of this server load only its content. Pages of other sites can neither embed nor read the answers.
constexpr std::string_view kSafeHeaders =
    "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
    "connect-src 'self'; frame-ancestors 'self'; base-uri 'none'; form-action 'none'\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cache-Control: no-store\r\n";

struct Reason {
  int status;
  std::string_view phrase, text;
};

constexpr Reason kReasons[] = {
    {200, "OK", ""},
    {204, "No Content", ""},
    {400, "Bad Request", "This is not an HTTP request.\n"},
    {403, "Forbidden", ""},
    {404, "Not Found", ""},
    {405, "Method Not Allowed", ""},
    {411, "Length Required", "A body needs a Content-Length; chunks are not supported.\n"},
    {413, "Content Too Large", "A body may have at most 1 MB.\n"},
    {415, "Unsupported Media Type", "Compressed bodies are not supported.\n"},
    {422, "Unprocessable Content", ""},
    {431, "Request Header Fields Too Large", "Headers may have at most 16 kB.\n"},
    {500, "Internal Server Error", "The answer could not be made.\n"},
    {505, "HTTP Version Not Supported", "The server supports HTTP/1.1 and HTTP/1.0.\n"},
};

Reason reason_of(int status) {
  const Reason* found =
      std::find_if(std::begin(kReasons), std::end(kReasons), [&](const Reason& one) { return one.status == status; });
  return found == std::end(kReasons) ? Reason{status, "", ""} : *found;
}

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

/// token of RFC 9110, 5.6.2
bool is_token(std::string_view text) {
  const auto allowed = [](char c) {
    return is_letter_or_digit(c) || std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), allowed);
}

bool is_control(char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f; }

std::string lower(std::string_view text) {
  std::string made(text);
  for (char& c : made)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return made;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t");
  return from == std::string_view::npos ? std::string_view() : text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

std::string_view cut_line(std::string_view& text) {
  const std::size_t end = text.find("\r\n");
  const std::string_view line = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end + 2);
  return line;
}

std::optional<std::string> decoded(std::string_view path) {
  std::string made;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] != '%') {
      made += path[i];
      continue;
    }
    unsigned code = 0;
    const std::string_view digits = path.substr(i + 1, 2);
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() < 2 || problem != std::errc() || end != digits.data() + 2) return std::nullopt;
    made += static_cast<char>(code);
    i += 2;
  }
  return made;
}

class Headers {
 public:
  bool read(std::string_view lines) {
    while (!lines.empty()) {
      const std::string_view line = cut_line(lines);
      const std::size_t colon = line.find(':');
      if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) return false;
      const std::string_view value = trimmed(line.substr(colon + 1));
      if (std::any_of(value.begin(), value.end(), is_control)) return false;
      fields_.push_back({lower(line.substr(0, colon)), value});
    }
    return true;
  }

  std::size_t count(std::string_view name) const {
    return static_cast<std::size_t>(
        std::count_if(fields_.begin(), fields_.end(), [&](const Field& field) { return field.name == name; }));
  }

  std::string_view value(std::string_view name) const {
    const auto found = std::find_if(fields_.begin(), fields_.end(), [&](const Field& field) { return field.name == name; });
    return found == fields_.end() ? std::string_view() : found->value;
  }

  bool has(std::string_view name) const { return count(name) > 0; }

 private:
  struct Field {
    std::string name;
    std::string_view value;
  };
  std::vector<Field> fields_;
};

std::optional<PageAnswer> read_first_line(std::string_view line, RequestHead& head) {
  const std::size_t first = line.find(' '), last = line.rfind(' ');
  if (first == std::string_view::npos || first == last || !is_token(line.substr(0, first))) return refusal_of(400);
  const std::string_view version = line.substr(last + 1);
  if (!version.starts_with("HTTP/")) return refusal_of(400);
  if (version != "HTTP/1.1" && version != "HTTP/1.0") return refusal_of(505);
  const std::string_view target = line.substr(first + 1, last - first - 1);
  const auto is_bad = [](char c) { return c == ' ' || c == '\t' || is_control(c); };
  if (std::any_of(target.begin(), target.end(), is_bad)) return refusal_of(400);
  const std::optional<std::string> path = decoded(target.substr(0, target.find_first_of("?#")));
  if (!path) return refusal_of(400);
  head.page.method = line.substr(0, first);
  head.page.path = *path;
  head.keeps_alive = version == "HTTP/1.1";
  return std::nullopt;
}

/// Reads the length of the body. Returns whether the length is unambiguous.
bool read_body_length(const Headers& headers, RequestHead& head) {
  if (headers.has("transfer-encoding")) {
    head.body_refusal = 411;
    return !headers.has("content-length");  // with both headers, a second request could be hidden in the body: RFC 9112, 6.1
  }
  if (headers.count("content-length") > 1) return false;
  const std::string_view text = headers.value("content-length");
  if (text.empty()) return !headers.has("content-length");
  if (text.find_first_not_of("0123456789") != std::string_view::npos) return false;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), head.body_bytes);
  if (problem != std::errc() || head.body_bytes > kMaxBodyBytes) head.body_refusal = 413;
  return true;
}

/// A coding with a weight (RFC 9110, 12.5.3) is left out: browsers send none, and the weight may be 0.
bool lists_gzip(std::string_view codings) {
  for (bool is_over = false; !is_over;) {
    const std::size_t comma = codings.find(',');
    if (lower(trimmed(codings.substr(0, comma))) == "gzip") return true;
    is_over = comma == std::string_view::npos;
    if (!is_over) codings.remove_prefix(comma + 1);
  }
  return false;
}

}  // namespace

PageAnswer refusal_of(int status) {
  return {status, "text/plain; charset=utf-8", std::make_shared<const std::string>(reason_of(status).text)};
}

std::variant<RequestHead, PageAnswer> read_head(std::string_view text) {
  RequestHead head;
  if (std::optional<PageAnswer> refusal = read_first_line(cut_line(text), head)) return *std::move(refusal);
  Headers headers;
  if (!headers.read(text) || headers.count("host") > 1 || headers.count("origin") > 1) return refusal_of(400);
  if (!read_body_length(headers, head)) return refusal_of(400);
  const std::string encoding = lower(headers.value("content-encoding"));
  if (!encoding.empty() && encoding != "identity") head.body_refusal = 415;
  head.page.host = headers.value("host");
  head.page.origin = headers.value("origin");
  head.page.fetch_site = headers.value("sec-fetch-site");
  head.page.accepts_gzip = lists_gzip(headers.value("accept-encoding"));
  head.awaits_continue = lower(headers.value("expect")) == "100-continue";
  const std::string connection = lower(headers.value("connection"));
  if (connection.find("keep-alive") != std::string::npos) head.keeps_alive = true;
  if (connection.find("close") != std::string::npos) head.keeps_alive = false;
  return head;
}

std::string head_of(const PageAnswer& answer, bool keeps_alive) {
  std::string head = fmt::format("HTTP/1.1 {} {}\r\n{}Connection: {}\r\n", answer.status, reason_of(answer.status).phrase,
                                 kSafeHeaders, keeps_alive ? "keep-alive" : "close");
  if (answer.body) head += fmt::format("Content-Type: {}\r\n", answer.type);
  if (!answer.coding.empty()) head += fmt::format("Content-Encoding: {}\r\n", answer.coding);
  if (answer.status != 204) head += fmt::format("Content-Length: {}\r\n", answer.body ? answer.body->size() : 0);
  return head + "\r\n";
}

}  // namespace lippmann
