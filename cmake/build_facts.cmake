# Only one source file is compiled with these definitions, so that a new commit recompiles only this file. The
# definitions contain no time and no path, so that equal sources give equal programs.

# Packagers who build from a tarball, which has no repository, can set -DLIPPMANN_COMMIT=...
set(LIPPMANN_COMMIT "" CACHE STRING "The commit that lippmann --version prints; default: the repository's, if there is one")

# Sets the variable named by `out` to the checked-out commit. CMake runs again when another commit is checked out.
function(lippmann_find_commit out)
  set(${out} "not known" PARENT_SCOPE)
  find_program(GIT_EXECUTABLE git)
  if(NOT GIT_EXECUTABLE OR NOT EXISTS ${PROJECT_SOURCE_DIR}/.git)
    return()
  endif()
  execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --short=12 HEAD WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed)
    return()
  endif()
  execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --git-path logs/HEAD WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  get_filename_component(log "${log}" ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
  if(EXISTS ${log})
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${log})
  endif()
  set(${out} ${commit} PARENT_SCOPE)
endfunction()

set(commit "${LIPPMANN_COMMIT}")
if(NOT commit)
  lippmann_find_commit(commit)
endif()
set(picture_libraries "OpenEXR ${OpenEXR_VERSION}, libpng ${PNG_VERSION_STRING}, libtiff ${TIFF_VERSION_STRING}, libwebp ${WebP_VERSION}")
if(LCMS_FOUND)
  string(APPEND picture_libraries ", Little CMS ${LCMS_VERSION}")
endif()
if(LIBHEIF_FOUND)
  string(APPEND picture_libraries ", libheif ${LIBHEIF_VERSION}")
endif()
if(HDF5_FOUND)
  string(APPEND picture_libraries ", libhdf5 ${HDF5_VERSION}")
endif()
set(LIPPMANN_BUILD_FACTS
  "LIPPMANN_COMMIT=\"${commit}\""
  "LIPPMANN_COMPILER=\"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\""
  "LIPPMANN_BUILD_TYPE=\"${CMAKE_BUILD_TYPE}\""
  "LIPPMANN_LIBAVCODEC=\"${FFmpeg_libavcodec_VERSION}\""
  "LIPPMANN_PICTURE_LIBRARIES=\"${picture_libraries}\"")
