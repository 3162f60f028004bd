// Suffixes that file managers and browsers append to the names of copies.
#pragma once

namespace lippmann {

/// A regular expression, to be matched without regard to case. It matches for example " (1)", " - Copy", " - Copy (2)",
/// " copy 2", " 2", "_copy" and "-1".
inline constexpr const char* kCopyMark = "(?: ?\\([0-9]{1,4}\\)| - [^_]{1,40}|[ _-]copy(?:[ _-][0-9]{1,4})?|[ -][0-9]{1,4})";

}  // namespace lippmann
