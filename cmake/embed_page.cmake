set(entries "")
set(texts "")
foreach(file "index.html|text/html" "app.js|text/javascript" "app.css|text/css")
  string(REGEX MATCH "^([^|]+)[|](.+)$" whole "${file}")
  set(name ${CMAKE_MATCH_1})
  set(type "${CMAKE_MATCH_2}; charset=utf-8")
  file(READ ${FOLDER}/${name} bytes HEX)
  string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(MAKE_C_IDENTIFIER "k_${name}" identifier)
  string(APPEND texts "constexpr unsigned char ${identifier}[] = {\n${bytes}};\n")
  string(APPEND entries "    {\"${name}\", \"${type}\", {reinterpret_cast<const char*>(${identifier}), sizeof ${identifier}}},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made from web/dist by cmake/embed_page.cmake.
#include \"view/page_files.hpp\"

namespace lippmann {
namespace {

${texts}
const PageFile kPageFiles[] = {
${entries}};

}  // namespace

std::span<const PageFile> page_files() { return kPageFiles; }

}  // namespace lippmann
")
