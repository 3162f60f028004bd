# Installs the library, builds the programs in examples/library as a separate project, and runs them.
#   cmake -D BUILD=... -D SOURCE=... -D CXX=... -D GENERATOR=... -D FLAGS=... -D PYTHON=... -P installed.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDERR OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "${output}")
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(require_file path)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "${path} is missing")
  endif()
endfunction()

set(work ${BUILD}/tests/library/work)
set(examples ${work}/build)
file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${BUILD} --component development --prefix ${work}/prefix)

# This separate project does not see the library's sources, so installed headers must be self-contained.
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE}/examples/library -B ${examples} -D CMAKE_PREFIX_PATH=${work}/prefix
  -D CMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_EXE_LINKER_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${examples})

# The program that renders a denoised path-traced quilt must have at most 20 lines of code, and its picture must equal the
# tool's.
file(READ ${SOURCE}/examples/library/quilt.cpp text)
string(REGEX REPLACE "(^|\n)//[^\n]*" "" text "${text}")
string(REGEX MATCHALL "\n[^\n]" lines "${text}")
list(LENGTH lines count)
if(count GREATER 20)
  message(FATAL_ERROR "examples/library/quilt.cpp has ${count} lines of code")
endif()
set(display ${CMAKE_CURRENT_LIST_DIR}/small_panel.toml)
run(${examples}/quilt ${SOURCE}/examples/desk.glb ${display} ${work}/desk.png)
require_file(${work}/desk_qs4x2a0.5625.png)
run(${BUILD}/lippmann render ${SOURCE}/examples/desk.glb --display ${display} --frames 0 -o ${work}/tool)
run(${CMAKE_COMMAND} -E compare_files ${work}/desk_qs4x2a0.5625.png ${work}/tool/frame_0000_qs4x2a0.5625.png)

run(${examples}/own_scene ${work}/ball)
foreach(frame 0 1 2 3)
  require_file(${work}/ball/panel_${frame}.png)
  if(NOT output MATCHES "frame ${frame}: [a-z]+, [1-9][0-9]* rays, -?[0-9.]+ mm at the middle")
    message(FATAL_ERROR "frame ${frame} is not reported: ${output}")
  endif()
endforeach()

run(${examples}/look ${work}/desk_qs4x2a0.5625.png ${work}/seen)
foreach(picture left right focused)
  require_file(${work}/seen/${picture}.png)
endforeach()

run(${examples}/data_set ${work}/data)
foreach(file input_Cam000.png input_Cam008.png gt_depth_lowres.pfm parameters.cfg)
  require_file(${work}/data/${file})
endforeach()

# A program with missing or wrong arguments must exit with `code` and a message that matches `pattern`.
function(run_refused code pattern)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result ERROR_VARIABLE said OUTPUT_QUIET)
  if(NOT result STREQUAL code OR NOT said MATCHES "${pattern}")
    message(FATAL_ERROR "${ARGN}: ended with ${result}, not ${code}: ${said}")
  endif()
endfunction()
foreach(program quilt own_scene look data_set)
  run_refused(2 "^usage: ${program} " ${examples}/${program})
  run_refused(2 "^usage: ${program} " ${examples}/${program} 1 2 3 4)
endforeach()
run_refused(1 "no-such-display" ${examples}/quilt ${SOURCE}/examples/desk.glb no-such-display ${work}/none.png)
run_refused(1 "no quilt" ${examples}/quilt ${SOURCE}/examples/desk.glb lenticular-60lpi-720dpi ${work}/none.png)
run_refused(1 "no-such-scene" ${examples}/quilt no-such-scene ${display} ${work}/none.png)
run_refused(1 "no-such-file" ${examples}/look no-such-file ${work}/seen)
run_refused(1 "CMakeLists.txt" ${examples}/own_scene ${SOURCE}/CMakeLists.txt/below)
run_refused(1 "CMakeLists.txt" ${examples}/data_set ${SOURCE}/CMakeLists.txt/below)

# Builds and installs a project in which warnings are errors. Every public struct must support designated initialisers.
set(outside ${work}/outside)
run(${PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/designators.py ${work}/prefix/include)
file(WRITE ${work}/designators.cpp "${output}")
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/outside -B ${outside} -D CMAKE_PREFIX_PATH=${work}/prefix
  -D CMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_EXE_LINKER_FLAGS=${FLAGS}"
  -D DESIGNATORS=${work}/designators.cpp)
run(${CMAKE_COMMAND} --build ${outside})
run(${CMAKE_COMMAND} --install ${outside} --prefix ${work}/elsewhere)
run(${work}/elsewhere/bin/triangle)
if(NOT output MATCHES "^([0-9]+\\.[0-9]+\\.[0-9]+), ([0-9.]+): 0.00 1.00 0.00\n$" OR NOT CMAKE_MATCH_1 STREQUAL CMAKE_MATCH_2)
  message(FATAL_ERROR "triangle prints ${output}")
endif()

find_program(pkg_config pkg-config REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${work}/prefix/lib/pkgconfig)
run(${pkg_config} --cflags --libs lippmann)
separate_arguments(flags UNIX_COMMAND "${FLAGS} -std=c++20 ${output}")
run(${CXX} ${SOURCE}/examples/library/look.cpp -o ${work}/look ${flags} -Wl,-rpath,${work}/prefix/lib)
run(${work}/look ${work}/desk_qs4x2a0.5625.png ${work}/seen_again)
run(${CMAKE_COMMAND} -E compare_files ${work}/seen/left.png ${work}/seen_again/left.png)
