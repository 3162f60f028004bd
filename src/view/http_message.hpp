// HTTP/1.1 messages as bytes: reads the head of a request, writes the head of an answer.
//
// Based on: RFC 9110 (HTTP semantics) and RFC 9112 (HTTP/1.1), 2022.
// We deviate: 1. bodies come with Content-Length, plain; chunked bodies are refused with 411, compressed ones with 415.
// 2. Folded header lines (RFC 9112, 5.2) and line ends without CR (2.2) are refused with 400, as both may be.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include "view/answers.hpp"

namespace lippmann {

/// Servers take heads of 8 KiB (Apache's LimitRequestFieldSize) to 16 KiB (Node's --max-http-header-size); browsers send
/// about 1.
inline constexpr std::size_t kMostHeadBytes = std::size_t{16} << 10;
/// A calibration has some 10 kB, settings less than 1.
inline constexpr std::size_t kMostBodyBytes = std::size_t{1} << 20;

struct RequestHead {
  PageRequest page;            ///< without its body
  std::size_t body_bytes = 0;  ///< that follow; at most kMostBodyBytes
  int body_refusal = 0;        ///< status of the answer if the body cannot be taken: 411, 413 or 415; 0: it can
  bool keeps_alive = true;
  bool awaits_continue = false;  ///< the client sends the body once it has been told to
};

/// The head of a request, without the empty line that ends it; an answer with status 400 or 505 for one that is malformed.
std::variant<RequestHead, PageAnswer> read_head(std::string_view head);

/// A refusal in plain text.
PageAnswer refusal_of(int status);

/// Status line and headers, with the empty line; `keeps_alive`: the connection stays open.
std::string head_of(const PageAnswer& answer, bool keeps_alive);

}  // namespace lippmann
