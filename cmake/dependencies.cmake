# Everything comes from Debian 12 packages; scripts/bootstrap installs them.

find_package(PkgConfig REQUIRED)
find_package(TBB REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)

# OpenImageIO's own CMake target names OpenCV's include folder and fails without libopencv-dev; its pkg-config file does not.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(FFmpeg REQUIRED IMPORTED_TARGET libavcodec libavformat libavutil libswscale)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
