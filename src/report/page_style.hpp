// The look of the page: src/report/page.css, which the build makes a source file of.
#pragma once

#include <string_view>

namespace lippmann {

std::string_view page_style();

}  // namespace lippmann
