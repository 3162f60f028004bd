#pragma once

namespace lippmann {

bool is_align_module_installed();

}  // namespace lippmann
