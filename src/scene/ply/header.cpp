#include "scene/ply/header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <span>

#include "core/file_content.hpp"
#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"
#include "scene/lexer.hpp"

namespace lippmann::ply {
namespace {

constexpr std::size_t kMostElements = 100, kMostProperties = 1000;

struct TypeName {
  std::string_view name;
  Type type;
};

constexpr TypeName kTypes[] = {
    {"char", Type::kInt8},   {"int8", Type::kInt8},     {"uchar", Type::kUint8},   {"uint8", Type::kUint8},
    {"short", Type::kInt16}, {"int16", Type::kInt16},   {"ushort", Type::kUint16}, {"uint16", Type::kUint16},
    {"int", Type::kInt32},   {"int32", Type::kInt32},   {"uint", Type::kUint32},   {"uint32", Type::kUint32},
    {"float", Type::kFloat}, {"float32", Type::kFloat}, {"double", Type::kDouble}, {"float64", Type::kDouble}};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(" \t\r"); at < line.size(); at = line.find_first_not_of(" \t\r", at)) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

class HeaderReader {
 public:
  HeaderReader(const std::string& name, std::string_view contents) : name_(name), contents_(contents) {}

  Header read() {
    if (words_of(next_line()) != std::vector<std::string_view>{"ply"}) throw not_ply();
    for (;;) {
      const std::string_view line = next_line();
      const std::vector<std::string_view> words = words_of(line);
      if (words.empty()) continue;
      if (words[0] == "end_header") break;
      if (words[0] == "comment" || words[0] == "obj_info")
        parse_comment(words, line);
      else
        parse(words);
    }
    if (!has_format_) throw error("the header has no format statement");
    header_.size = position_;
    return std::move(header_);
  }

 private:
  std::string_view next_line() {
    ++line_;
    const std::size_t end = contents_.find('\n', position_);
    if (end == contents_.npos) throw error("the file ends within its header", "a line \"end_header\"");
    const std::string_view line = contents_.substr(position_, end - position_);
    position_ = end + 1;
    return line;
  }

  Error not_ply() const {
    const std::string what = describe_content(std::as_bytes(std::span(contents_))).what;
    return error(fmt::format("is not a PLY file but {}", what), "a first line \"ply\"");
  }

  /// Reads the comments that contain information: texture files and the vertical axis.
  void parse_comment(const std::vector<std::string_view>& words, std::string_view line) {
    if (words.size() > 2 && is_keyword(words[1], "TEXTUREFILE")) {
      const auto begin = static_cast<std::size_t>(words[2].data() - line.data());
      std::string name(line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin));
      std::replace(name.begin(), name.end(), '\\', '/');
      header_.texture_files.push_back(std::move(name));
    }
    if (words.size() == 4 && words[1] == "Vertical" && words[2] == "Axis:") header_.is_z_up = is_keyword(words[3], "Z");
  }

  void parse(const std::vector<std::string_view>& words) {
    if (words[0] == "format" && words.size() == 3)
      parse_format(words[1], words[2]);
    else if (words[0] == "element" && words.size() == 3)
      add_element(words[1], words[2]);
    else if (words[0] == "property" && words.size() == 3)
      add_property({std::string(words[2]), type(words[1]), {}});
    else if (words[0] == "property" && words.size() == 5 && words[1] == "list")
      add_property({std::string(words[4]), type(words[3]), type(words[2])});
    else if (resembles_statement(words[0]))
      throw error(fmt::format("{} is not a statement of the header", shown(words[0])),
                  "format NAME 1.0, element NAME COUNT, property TYPE NAME, property list TYPE TYPE NAME, comment, end_header");
    else
      header_.foreign_lines.add(words[0], fmt::format("{}:{}", name_, line_));
  }

  /// Returns whether a line is probably a damaged statement. All other unknown lines count as comments because some programs
  /// omit the keyword `comment`.
  static bool resembles_statement(std::string_view word) {
    constexpr std::string_view kStatements[] = {"format", "element", "property", "end_header"};
    constexpr int kMisspelt = 2;
    return std::any_of(std::begin(kStatements), std::end(kStatements),
                       [&](std::string_view statement) { return edit_distance(word, statement) <= kMisspelt; });
  }

  void parse_format(std::string_view format, std::string_view version) {
    if (format == "ascii")
      header_.format = Format::kText;
    else if (format == "binary_little_endian")
      header_.format = Format::kLittleEndian;
    else if (format == "binary_big_endian")
      header_.format = Format::kBigEndian;
    else
      throw error(fmt::format("{} is not a format", shown(format)), "ascii, binary_little_endian, binary_big_endian");
    if (version != "1.0") throw error(fmt::format("the version is {}", shown(version)), "1.0");
    has_format_ = true;
  }

  void add_element(std::string_view element, std::string_view digits) {
    std::int32_t count = -1;
    const auto [rest, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (failure != std::errc{} || rest != digits.data() + digits.size() || count < 0)
      throw error(fmt::format("{} is not a number of elements", shown(digits)), "0 to 2147483647");
    if (header_.elements.size() == kMostElements)
      throw error("there are too many elements", fmt::format("at most {}", kMostElements));
    header_.elements.push_back({std::string(element), count, {}});
  }

  void add_property(Property property) {
    if (header_.elements.empty()) throw error("a property precedes the first element");
    std::vector<Property>& properties = header_.elements.back().properties;
    if (properties.size() == kMostProperties)
      throw error("there are too many properties", fmt::format("at most {}", kMostProperties));
    if (property.count_type && *property.count_type >= Type::kFloat) throw error("the length of a list is not a whole number");
    properties.push_back(std::move(property));
  }

  Type type(std::string_view word) const {
    const auto* known = std::find_if(std::begin(kTypes), std::end(kTypes), [&](const TypeName& t) { return t.name == word; });
    if (known == std::end(kTypes))
      throw error(fmt::format("{} is not a type", shown(word)), "char, uchar, short, ushort, int, uint, float, double");
    return known->type;
  }

  Error error(std::string problem, std::string accepted = {}) const {
    return {fmt::format("{}:{}", name_, line_), std::move(problem), std::move(accepted)};
  }

  const std::string& name_;
  std::string_view contents_;
  std::size_t position_ = 0;
  int line_ = 0;
  bool has_format_ = false;
  Header header_;
};

}  // namespace

int bytes_of(Type type) {
  constexpr int kBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[static_cast<int>(type)];
}

Header parse_header(const std::string& name, std::string_view contents) { return HeaderReader(name, contents).read(); }

}  // namespace lippmann::ply
