#include "align/align_module.hpp"

#include "align/align_module_file.hpp"
#include "core/loaded_module.hpp"

namespace lippmann {
namespace {

constexpr ModuleName kAlignModule{"liblippmann_align.so", "lippmann_align_module", "alignment and depth from two pictures",
                                  "lippmann-align"};

}  // namespace

const AlignModule& align_module() {
  static const auto& loaded = *static_cast<const AlignModule*>(load_module(kAlignModule, kAlignModuleVersion));
  return loaded;
}

bool is_align_module_installed() { return is_module_installed(kAlignModule); }

}  // namespace lippmann
