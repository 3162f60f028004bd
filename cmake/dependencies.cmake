# All dependencies are packages of Debian 12 or newer; scripts/bootstrap installs them.

find_package(PkgConfig REQUIRED)
find_package(TBB REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(embree 4 QUIET)  # Debian 13 has Embree 4, Debian 12 has 3.13; src/device/embree_shim.hpp hides the difference
if(NOT embree_FOUND)
  find_package(embree 3.13 REQUIRED)
endif()
find_package(nlohmann_json REQUIRED)
find_package(meshoptimizer REQUIRED)
if(LIPPMANN_TOOL OR LIPPMANN_BENCH)
  find_package(CLI11 REQUIRED)
endif()
if(LIPPMANN_TESTS)
  find_package(GTest REQUIRED)
endif()

find_package(ZLIB REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(TIFF REQUIRED)
find_package(OpenEXR 3.1 REQUIRED CONFIG)
find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(WebP REQUIRED IMPORTED_TARGET libwebp)
pkg_check_modules(LCMS IMPORTED_TARGET lcms2)  # optional, for colour profiles of pictures
pkg_check_modules(LIBHEIF IMPORTED_TARGET libheif>=1.12)  # optional, for HEIC and AVIF pictures
pkg_check_modules(HDF5 IMPORTED_TARGET hdf5)  # optional, for HCI light fields in HDF5 files
pkg_check_modules(FFmpeg REQUIRED IMPORTED_TARGET libavcodec libavformat libavutil libswscale)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)

# Prefer the static library, because Debian's shared libdraco exports copies of image and glTF readers, whose symbols clash with
# ours. Fedora and Arch package only the shared library.
find_library(DRACO_LIBRARY NAMES libdraco.a draco REQUIRED)
find_path(DRACO_INCLUDE_DIR draco/draco_features.h REQUIRED)
add_library(draco::library UNKNOWN IMPORTED)
set_target_properties(draco::library PROPERTIES
  IMPORTED_LOCATION ${DRACO_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES ${DRACO_INCLUDE_DIR})

# OpenCV is searched without its CMake files, because only libopencv-dev contains them, and this package installs VTK, too.
find_path(OPENCV_INCLUDE_DIR opencv2/calib3d.hpp PATH_SUFFIXES opencv4)
set(OPENCV_LIBRARIES "")
foreach(component core features2d calib3d)
  find_library(OPENCV_${component}_LIBRARY opencv_${component})
  list(APPEND OPENCV_LIBRARIES ${OPENCV_${component}_LIBRARY})
endforeach()
