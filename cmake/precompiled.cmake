# Precompiles headers that many files include, which saves a quarter of the time of a first build. With a compiler launcher, the
# default is OFF, because each object would depend on all these headers, which makes a compiler cache useless. Every file compiles
# without precompiled headers.

set(precompile ON)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR CMAKE_CXX_COMPILER_LAUNCHER OR LIPPMANN_SANITIZE)
  set(precompile OFF)
endif()
option(LIPPMANN_PCH "Precompile headers; default: only without a compiler launcher" ${precompile})

# lippmann_precompiled_headers(NAME HEADERS ... DEPENDS ...): declares the target NAME, which precompiles HEADERS with the compile
# options of DEPENDS.
function(lippmann_precompiled_headers name)
  cmake_parse_arguments(PCH "" "" "HEADERS;DEPENDS" ${ARGN})
  if(NOT LIPPMANN_PCH)
    return()
  endif()
  set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// The target of this source provides precompiled headers.\n")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE lippmann_options ${PCH_DEPENDS})
  list(TRANSFORM PCH_HEADERS REPLACE "(.+)" "<\\1>")
  target_precompile_headers(${name} PRIVATE ${PCH_HEADERS})
endfunction()

# lippmann_use_precompiled(TARGET NAME): compiles TARGET with the precompiled headers NAME, if precompiled headers are enabled.
function(lippmann_use_precompiled target name)
  if(LIPPMANN_PCH)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()

set(LIPPMANN_COMMON_HEADERS
  algorithm array charconv cmath cstdint cstring filesystem fstream functional limits map memory numeric optional span string
  string_view utility variant vector fmt/format.h glm/glm.hpp glm/gtc/quaternion.hpp)
lippmann_precompiled_headers(lippmann_common_headers HEADERS ${LIPPMANN_COMMON_HEADERS} DEPENDS fmt::fmt glm::glm)
