# ELF linkers (GNU ld, gold, lld, mold) get the flags below. Other linkers get none.

set(LIPPMANN_ELF_LINKER OFF)
if(UNIX AND NOT APPLE)
  set(LIPPMANN_ELF_LINKER ON)
endif()

# lippmann_link(TARGET [EXPORTS FILE] [HIDE_ARCHIVES] [COMPLETE] [SMALL]): sets linker flags, so that TARGET depends only on shared
# libraries that it uses.
# EXPORTS: a version script of the exported symbols.
# HIDE_ARCHIVES: hides symbols of static libraries.
# COMPLETE: reports undefined symbols when linking instead of when loading.
# SMALL: removes code that is never called.
function(lippmann_link target)
  cmake_parse_arguments(LINK "HIDE_ARCHIVES;COMPLETE;SMALL" "EXPORTS" "" ${ARGN})
  if(NOT LIPPMANN_ELF_LINKER)
    return()
  endif()
  if(LINK_EXPORTS)
    target_link_options(${target} PRIVATE -Wl,--version-script=${LINK_EXPORTS})
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${LINK_EXPORTS})
  endif()
  if(LINK_HIDE_ARCHIVES)
    target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL)
  endif()
  target_link_options(${target} PRIVATE -Wl,--as-needed)
  if(LINK_COMPLETE)
    target_link_options(${target} PRIVATE -Wl,--no-undefined)
  endif()
  if(LINK_SMALL)
    target_link_options(${target} PRIVATE -Wl,--gc-sections)
  endif()
endfunction()
