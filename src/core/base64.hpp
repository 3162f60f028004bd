#pragma once

#include <string>
#include <string_view>

namespace lippmann {

std::string base64(std::string_view bytes);

}  // namespace lippmann
