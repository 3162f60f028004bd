# Precompiled headers: those of standard and third-party libraries that many files include. They spare a first build a quarter of
# its time and cost a compiler cache its hits (each object depends on all of them), so they are on where no compiler launcher is
# set. Every file still includes all that it uses, and compiles without them.

set(precompile ON)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR CMAKE_CXX_COMPILER_LAUNCHER OR LIPPMANN_SANITIZE)
  set(precompile OFF)
endif()
option(LIPPMANN_PCH "Precompile headers; by default only where no compiler launcher is set" ${precompile})

# lippmann_precompiled_headers(NAME HEADERS ... DEPENDS ...): for targets whose compile options are those of DEPENDS.
function(lippmann_precompiled_headers name)
  cmake_parse_arguments(PCH "" "" "HEADERS;DEPENDS" ${ARGN})
  if(NOT LIPPMANN_PCH)
    return()
  endif()
  set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Its target is there for its precompiled headers.\n")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE lippmann_options ${PCH_DEPENDS})
  list(TRANSFORM PCH_HEADERS REPLACE "(.+)" "<\\1>")
  target_precompile_headers(${name} PRIVATE ${PCH_HEADERS})
endfunction()

# lippmann_use_precompiled(TARGET NAME): compiles TARGET with them, where they are on.
function(lippmann_use_precompiled target name)
  if(LIPPMANN_PCH)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()

set(LIPPMANN_COMMON_HEADERS
  algorithm array charconv cmath cstdint cstring filesystem fstream functional limits map memory numeric optional span string
  string_view utility variant vector fmt/format.h glm/glm.hpp glm/gtc/quaternion.hpp)
lippmann_precompiled_headers(lippmann_common_headers HEADERS ${LIPPMANN_COMMON_HEADERS} DEPENDS fmt::fmt glm::glm)
