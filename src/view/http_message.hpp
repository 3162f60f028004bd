// Parses the heads of HTTP/1.1 requests and formats the heads of answers.
//
// Based on: RFC 9110 (HTTP semantics) and RFC 9112 (HTTP/1.1), 2022.
//
// We deviate:
// 1. Bodies need a Content-Length and no coding; chunked bodies are refused with 411, compressed ones with 415.
// 2. Folded header lines (RFC 9112, 5.2) and line ends without CR (2.2) are refused with 400, as the RFC permits.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include "view/answers.hpp"

namespace lippmann {

/// Largest head. Browsers send about 1 KiB. Other servers limit heads to 8 KiB (Apache) or 16 KiB (Node).
inline constexpr std::size_t kMaxHeadBytes = std::size_t{16} << 10;
/// Largest body. A calibration has about 10 kB.
inline constexpr std::size_t kMaxBodyBytes = std::size_t{1} << 20;

struct RequestHead {
  PageRequest page;
  std::size_t body_bytes = 0;
  int body_refusal = 0;  ///< status if the body is refused: 411, 413 or 415; 0: accepted
  bool keeps_alive = true;
  bool awaits_continue = false;  ///< the client sends the body only after "100 Continue"
};

/// Parses a head without the empty line at its end. Returns an answer with status 400 or 505 if the head is malformed.
std::variant<RequestHead, PageAnswer> read_head(std::string_view head);

PageAnswer refusal_of(int status);

/// Returns the status line and headers, with the empty line after them. keeps_alive: the connection stays open.
std::string head_of(const PageAnswer& answer, bool keeps_alive);

}  // namespace lippmann
