# Debian packages, by `cpack -G DEB` in the build folder: the tool; the module for videos, which alone needs FFmpeg; the library
# for other programs; the Python package, which contains what it needs of the library.

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # tests and benchmarks need not be built for a package
set(CPACK_PACKAGE_NAME lippmann)
set(CPACK_PACKAGE_CONTACT "The authors of Lippmann <lippmann@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL tool video development)
if(TARGET lippmann_mpi_module)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
endif()
# Nothing depends on the Python module: scripts/demo, for one, leaves it unbuilt, and then cpack leaves its package out.
if(TARGET lippmann_python)
  list(APPEND CPACK_COMPONENTS_ALL python3)
  set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/built_components.cmake)
  file(GENERATE OUTPUT ${CPACK_PROJECT_CONFIG_FILE} CONTENT
    "if(NOT EXISTS \"$<TARGET_FILE:lippmann_python>\")\n  list(REMOVE_ITEM CPACK_COMPONENTS_ALL python3)\nendif()\n")
endif()
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME lippmann)
set(CPACK_DEBIAN_TOOL_PACKAGE_SUGGESTS lippmann-video)
set(CPACK_DEBIAN_VIDEO_PACKAGE_NAME lippmann-video)
set(CPACK_DEBIAN_VIDEO_PACKAGE_DEPENDS "lippmann (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_VIDEO_DESCRIPTION "Writes and reads videos for Lippmann")
set(CPACK_DEBIAN_MPI_PACKAGE_NAME lippmann-mpi)
set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "lippmann (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_MPI_PACKAGE_RECOMMENDS openmpi-bin)
set(CPACK_COMPONENT_MPI_DESCRIPTION "Renders with Lippmann on many machines through Open MPI")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME lippmann-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libglm-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS lippmann-video)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Lippmann as a library: headers, shared object, CMake and pkg-config files")
set(CPACK_DEBIAN_PYTHON3_PACKAGE_NAME python3-lippmann)
set(CPACK_DEBIAN_PYTHON3_PACKAGE_SECTION python)
# The module is for one minor version of Python; NumPy is loaded by name, which shlibdeps does not see.
set(CPACK_DEBIAN_PYTHON3_PACKAGE_DEPENDS
  "python3 (>= ${LIPPMANN_PYTHON_VERSION}), python3 (<< ${LIPPMANN_PYTHON_NEXT_VERSION}), python3-numpy")
set(CPACK_DEBIAN_PYTHON3_PACKAGE_SUGGESTS python3-xarray)
set(CPACK_COMPONENT_PYTHON3_DESCRIPTION "Lippmann for Python: light fields as arrays of NumPy")
include(CPack)
