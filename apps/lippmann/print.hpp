// Prints text without an exception where nobody reads it any more: the work goes on, and main() says at the end what standard
// output could not take.
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <utility>

namespace lippmann::app {

inline void print_text(std::FILE* stream, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stream);  // a failure stays in ferror()
}

/// On standard output.
template <class... Values>
void print_out(fmt::format_string<Values...> format, Values&&... values) {
  print_text(stdout, fmt::format(format, std::forward<Values>(values)...));
}

/// On standard error, where a failure is of no account.
template <class... Values>
void print_error(fmt::format_string<Values...> format, Values&&... values) {
  print_text(stderr, fmt::format(format, std::forward<Values>(values)...));
}

}  // namespace lippmann::app
