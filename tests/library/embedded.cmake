# Adds the whole source tree to another project. The project must build only the library, without the tool, the tests
# and their dependencies.
#   cmake -D SOURCE=... -D WORK=... -D CXX=... -P embedded.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/CMakeLists.txt "
cmake_minimum_required(VERSION 3.25)
project(embedder LANGUAGES CXX)
add_subdirectory(${SOURCE} lippmann)
add_executable(program ${SOURCE}/examples/library/look.cpp)
target_link_libraries(program PRIVATE lippmann::lippmann)
foreach(target lippmann cli_test lippmann-bench)
  if(TARGET \${target})
    message(FATAL_ERROR \"\${target} is built but not needed\")
  endif()
endforeach()
get_target_property(options program COMPILE_OPTIONS)
if(options)
  message(FATAL_ERROR \"the project's options reach the program: \${options}\")
endif()
")
execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${WORK} -B ${WORK}/build -D CMAKE_CXX_COMPILER=${CXX}
  -D CMAKE_BUILD_TYPE=Release -D LIPPMANN_PCH=OFF COMMAND_ERROR_IS_FATAL ANY)

# A dry run (-n) checks that the build has rules for everything, without compiling the library again.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --target program -- -n COMMAND_ERROR_IS_FATAL ANY)
# Compiles one example with the include directories and options that the library exports.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --target CMakeFiles/program.dir${SOURCE}/examples/library/look.cpp.o
  COMMAND_ERROR_IS_FATAL ANY)
