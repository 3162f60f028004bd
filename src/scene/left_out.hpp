// Collects the names of elements that an importer skips, so that one warning reports all of them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

class LeftOut {
 public:
  /// Adds the name of a skipped element found at `where`. The name may be untrusted text. Repeated names are only counted.
  void add(std::string_view name, const std::string& where);

  /// Returns whether nothing has been added. Callers can skip computing `where` for all elements after the first.
  bool empty() const { return count_ == 0; }

  /// Warns once about all elements, with the location of the first: "a.obj:3: the statements 'curv' and 'surf' are left out."
  void warn(const Context& context, std::string_view singular, std::string_view plural) const;

 private:
  std::vector<std::string> names_;
  std::string first_;
  std::size_t count_ = 0;
};

/// Formats the first ten names for a message: "'a', 'b' and 'c'". Names may be untrusted text.
std::string listed(std::span<const std::string> names);

}  // namespace lippmann
