# Writes OUTPUT, the C++ source of preset_files() (src/display/presets.hpp), from the files FOLDER/*.toml, unless it is up to
# date.
file(GLOB files ${FOLDER}/*.toml)
list(SORT files)
set(entries "")
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME_WLE)
  file(READ ${file} text)
  string(APPEND entries "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE ${OUTPUT}.new "// Made from data/displays by cmake/embed_displays.cmake.
#include \"display/presets.hpp\"

namespace lippmann {
namespace {

constexpr PresetFile kPresets[] = {
${entries}};

}  // namespace

std::span<const PresetFile> preset_files() { return kPresets; }

}  // namespace lippmann
")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(REMOVE ${OUTPUT}.new)
