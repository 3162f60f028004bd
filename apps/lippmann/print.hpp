// Prints text. Does not throw if the reader of a pipe has gone; main() reports the failure at the end.
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <utility>

namespace lippmann::app {

inline void print_text(std::FILE* stream, const std::string& text) { std::fwrite(text.data(), 1, text.size(), stream); }

template <class... Values>
void print_out(fmt::format_string<Values...> format, Values&&... values) {
  print_text(stdout, fmt::format(format, std::forward<Values>(values)...));
}

template <class... Values>
void print_error(fmt::format_string<Values...> format, Values&&... values) {
  print_text(stderr, fmt::format(format, std::forward<Values>(values)...));
}

}  // namespace lippmann::app
