#include "core/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/printable.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

/// Follows a parser and remembers the position of its first error.
class ErrorFinder final : public nlohmann::json_sax<Json> {
 public:
  std::size_t bytes_read = 0;  ///< number of bytes up to and including the error
  std::string member;          ///< member with the error; empty: the document itself

  bool null() override { return end_value(); }
  bool boolean(bool) override { return end_value(); }
  bool number_integer(number_integer_t) override { return end_value(); }
  bool number_unsigned(number_unsigned_t) override { return end_value(); }
  bool number_float(number_float_t, const string_t&) override { return end_value(); }
  bool string(string_t&) override { return end_value(); }
  bool binary(binary_t&) override { return end_value(); }
  bool start_object(std::size_t) override { return start({.is_list = false}); }
  bool start_array(std::size_t) override { return start({.is_list = true}); }
  bool end_object() override {
    open_.pop_back();
    return end_value();
  }
  bool end_array() override { return end_object(); }
  bool key(string_t& name) override {
    open_.back().name = name;
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
    bytes_read = position;
    for (const Container& container : open_) {
      if (container.is_list)
        member += fmt::format("[{}]", container.index);
      else if (!container.name.empty())
        member += (member.empty() ? "" : ".") + container.name;
    }
    return false;
  }

 private:
  struct Container {
    bool is_list;
    std::size_t index = 0;  ///< number of elements that were read
    std::string name = {};  ///< name of the last member
  };

  bool start(Container container) {
    open_.push_back(std::move(container));
    return true;
  }
  bool end_value() {
    if (!open_.empty() && open_.back().is_list) ++open_.back().index;
    return true;
  }

  std::vector<Container> open_;
};

/// Returns the word or the character at a position.
std::string_view word_at(std::string_view text, std::size_t position) {
  const auto is_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '.';
  };
  std::size_t begin = position, end = position + 1;
  if (!is_word(text[position])) return text.substr(position, 1);
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  while (end < text.size() && is_word(text[end])) ++end;
  return text.substr(begin, end - begin);
}

}  // namespace

nlohmann::ordered_json json_from_text(std::string_view text) { return nlohmann::ordered_json::parse(text, nullptr, false); }

Error json_error(std::string_view text, const std::string& where) {
  ErrorFinder finder;
  Json::sax_parse(text, &finder);
  const std::string place = finder.member.empty() ? where : where + ": " + printable(finder.member);
  if (finder.bytes_read == 0 || finder.bytes_read > text.size()) return {place, "is not JSON: it ends too early"};
  return {place, fmt::format("{} is not JSON", shown(word_at(text, finder.bytes_read - 1))), "JSON with finite numbers"};
}

std::string json_to_text(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace lippmann
