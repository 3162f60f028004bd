// Collects the names of elements that an importer skips, for a single warning.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

class LeftOut {
 public:
  /// Adds an untrusted name found at `where`. Repeated names are only counted.
  void add(std::string_view name, const std::string& where);

  /// Returns whether nothing has been added. Only the first element needs a `where`.
  bool empty() const { return count_ == 0; }

  /// Warns once, naming the location of the first element: "a.obj:3: the statements 'curv' and 'surf' are left out."
  void warn(const Context& context, std::string_view singular, std::string_view plural) const;

 private:
  std::vector<std::string> names_;
  std::string first_;
  std::size_t count_ = 0;
};

/// Lists the first ten of some untrusted names: "'a', 'b' and 'c'".
std::string listed(std::span<const std::string> names);

}  // namespace lippmann
