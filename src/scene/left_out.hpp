#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

class LeftOut {
 public:
  void add(std::string_view name, const std::string& where);

  bool empty() const { return count_ == 0; }

  /// Warns once about all elements, with the location of the first: "a.obj:3: the statements 'curv' and 'surf' are left out."
  void warn(const Context& context, std::string_view singular, std::string_view plural) const;

 private:
  std::vector<std::string> names_;
  std::string first_;
  std::size_t count_ = 0;
};

std::string listed(std::span<const std::string> names);

}  // namespace lippmann
