# The library for other programs: all parts in one shared object, and the headers of include/lippmann. Programs find it by:
#   find_package(lippmann)            target lippmann::lippmann of an installed library
#   add_subdirectory(lippmann)        the same target, built with the program
#   pkg-config --cflags --libs lippmann

get_property(parts GLOBAL PROPERTY LIPPMANN_PARTS)
set(source ${PROJECT_BINARY_DIR}/lippmann_library.cpp)
file(CONFIGURE OUTPUT ${source} CONTENT "// The library consists of the objects of its parts.\n")
add_library(lippmann_library SHARED ${source})
add_library(lippmann::lippmann ALIAS lippmann_library)
set_target_properties(lippmann_library PROPERTIES
  OUTPUT_NAME lippmann
  EXPORT_NAME lippmann
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
target_compile_features(lippmann_library INTERFACE cxx_std_20)
target_include_directories(lippmann_library INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
target_link_libraries(lippmann_library PUBLIC glm::glm)
foreach(part ${parts})
  target_sources(lippmann_library PRIVATE $<TARGET_OBJECTS:lippmann_${part}>)
  target_link_libraries(lippmann_library PRIVATE lippmann_${part})
endforeach()
# The version script hides the symbols of stb and Draco, because programs may contain their own copies.
set(complete COMPLETE)
if(LIPPMANN_SANITIZE)
  set(complete "")  # the sanitizer's symbols stay undefined until the program is linked
endif()
lippmann_link(lippmann_library EXPORTS ${PROJECT_SOURCE_DIR}/cmake/exported_symbols.map ${complete})

include(CMakePackageConfigHelpers)
set(package_folder lib/cmake/lippmann)
configure_package_config_file(cmake/lippmann-config.cmake.in ${PROJECT_BINARY_DIR}/lippmann-config.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lippmann-config-version.cmake COMPATIBILITY SameMinorVersion)
configure_file(cmake/lippmann.pc.in ${PROJECT_BINARY_DIR}/lippmann.pc @ONLY)

install(TARGETS lippmann_library EXPORT lippmann-targets LIBRARY DESTINATION lib COMPONENT development)
install(DIRECTORY include/lippmann DESTINATION include COMPONENT development)
install(EXPORT lippmann-targets NAMESPACE lippmann:: DESTINATION ${package_folder} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/lippmann-config.cmake ${PROJECT_BINARY_DIR}/lippmann-config-version.cmake
  DESTINATION ${package_folder} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/lippmann.pc DESTINATION lib/pkgconfig COMPONENT development)
