# Debian packages, by `cpack -G DEB` in the build folder: the tool; the module for videos, which alone needs FFmpeg; the library
# for other programs.

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # tests and benchmarks need not be built for a package
set(CPACK_PACKAGE_NAME lippmann)
set(CPACK_PACKAGE_CONTACT "The authors of Lippmann <lippmann@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL tool video development)
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME lippmann)
set(CPACK_DEBIAN_TOOL_PACKAGE_SUGGESTS lippmann-video)
set(CPACK_DEBIAN_VIDEO_PACKAGE_NAME lippmann-video)
set(CPACK_DEBIAN_VIDEO_PACKAGE_DEPENDS "lippmann (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_VIDEO_DESCRIPTION "Writes and reads videos for Lippmann")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME lippmann-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libglm-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS lippmann-video)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Lippmann as a library: headers, shared object, CMake and pkg-config files")
include(CPack)
