# Checks the example of docs/develop/add-an-optics-model.md: applies parallel_view.patch to a copy of the sources, and runs the
# test of the new model.
#   cmake -D SOURCE=... -D WORK=... -D CORE=... -D CXX=... -D LAUNCHER=... -D SANITIZE=... -P check.cmake
cmake_minimum_required(VERSION 3.25)

set(tree ${WORK}/tree)
file(REMOVE_RECURSE ${tree})
file(COPY ${SOURCE}/CMakeLists.txt ${SOURCE}/cmake ${SOURCE}/include ${SOURCE}/src DESTINATION ${tree})
file(COPY ${SOURCE}/tests/optics ${SOURCE}/tests/support DESTINATION ${tree}/tests)

find_program(patch patch REQUIRED)
set(file ${CMAKE_CURRENT_LIST_DIR}/parallel_view.patch)
execute_process(COMMAND ${patch} -p1 --forward --no-backup-if-mismatch -i ${file} WORKING_DIRECTORY ${tree}
  COMMAND_ERROR_IS_FATAL ANY)

# The page must name each file of the patch, with NAME in place of parallel_view. The patch leaves out CHANGELOG.md.
file(STRINGS ${file} touched REGEX "^\\+\\+\\+ b/")
list(LENGTH touched count)
if(count GREATER 6)
  message(FATAL_ERROR "a model takes ${count} files, without CHANGELOG.md; docs/develop/add-an-optics-model.md promises 6")
endif()
file(READ ${SOURCE}/docs/develop/add-an-optics-model.md page)
foreach(line IN LISTS touched)
  string(REGEX REPLACE "^\\+\\+\\+ b/" "" path "${line}")
  string(REPLACE parallel_view NAME path "${path}")
  string(FIND "${page}" "`${path}`" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "docs/develop/add-an-optics-model.md does not name `${path}`")
  endif()
endforeach()

# The patch leaves src/core as it is, so the test links the finished library CORE.
file(STRINGS ${file} changed_core REGEX "^\\+\\+\\+ b/(src|include/lippmann)/core/")
if(changed_core)
  message(FATAL_ERROR "the patch changes the part core, which this test does not compile: ${changed_core}")
endif()
file(WRITE ${tree}/src/core/CMakeLists.txt "
add_library(lippmann_core STATIC IMPORTED GLOBAL)
set_target_properties(lippmann_core PROPERTIES IMPORTED_LOCATION ${CORE})
target_link_libraries(lippmann_core INTERFACE lippmann_options glm::glm fmt::fmt nlohmann_json::nlohmann_json TBB::tbb
  PkgConfig::xxhash ${CMAKE_DL_LIBS})
add_library(lippmann::core ALIAS lippmann_core)
")

file(WRITE ${WORK}/CMakeLists.txt "
cmake_minimum_required(VERSION 3.25)
project(add_a_model LANGUAGES CXX)
add_subdirectory(tree lippmann)
find_package(GTest REQUIRED)
add_executable(model_test tree/tests/optics/parallel_view_test.cpp)
target_compile_features(model_test PRIVATE cxx_std_20)
target_include_directories(model_test PRIVATE tree/tests)
target_link_libraries(model_test PRIVATE lippmann::optics GTest::gtest_main)
")
execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${WORK} -B ${WORK}/build -D CMAKE_CXX_COMPILER=${CXX}
  -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG= -D LIPPMANN_UNITY=ON
  -D LIPPMANN_PCH=OFF -D LIPPMANN_SANITIZE=${SANITIZE} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --target model_test -- -j2 COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/model_test --gtest_brief=1 COMMAND_ERROR_IS_FATAL ANY)
