// Collects the names of what an importer does not read, for one warning that lists them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

class LeftOut {
 public:
  /// Adds a name of foreign origin that stands at `where`. Names that were added before only count.
  void add(std::string_view name, const std::string& where);

  /// Whether nothing was added: the place of later ones is not used.
  bool empty() const { return count_ == 0; }

  /// Warns at the first place, if there is one: "a.obj:3: the statements 'curv' and 'surf' are left out."
  void warn(const Context& context, std::string_view singular, std::string_view plural) const;

 private:
  std::vector<std::string> names_;
  std::string first_;
  std::size_t count_ = 0;
};

/// "'a', 'b' and 'c'": names of foreign origin, the first ten of them.
std::string listed(std::span<const std::string> names);

}  // namespace lippmann
