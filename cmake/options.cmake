# Compile options that every target shares (INTERFACE target lippmann_options), and helpers to declare parts.

add_library(lippmann_options INTERFACE)
target_include_directories(lippmann_options INTERFACE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
target_compile_options(lippmann_options INTERFACE -Wall -Wextra -Wshadow -Wno-unknown-pragmas)
# Designated initialisers leave the other members at their defaults on purpose.
target_compile_options(lippmann_options INTERFACE -Wno-missing-field-initializers)
# Packets by value have another ABI for each instruction set, and since GCC 4.6. No packet crosses the library's boundary.
target_compile_options(lippmann_options INTERFACE -Wno-psabi)
# GCC 13 takes any reference that a function returns for one to its argument, if that is a temporary.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13 AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 14)
  target_compile_options(lippmann_options INTERFACE -Wno-dangling-reference)
endif()
# Loops over lanes join comparisons with & and |, which vectorise, where && and || would branch.
target_compile_options(lippmann_options INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)

# Clang 19 and later leave out constructors that only versions of a function (core/multiversion.hpp) call, unless told so.
target_compile_options(lippmann_options INTERFACE
  $<$<AND:$<COMPILE_LANG_AND_ID:CXX,Clang>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,19>>:SHELL:-Xclang -mno-constructor-aliases>)

# Floating point: contraction to FMA is off, so that every instruction-set clone of a kernel (core/multiversion.hpp) gives the
# same bits; errno and traps are not used, which lets the compiler vectorise floor, sqrt and selects.
target_compile_options(lippmann_options INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)

# Parts are joined in a shared library, too (library.cmake), within which functions call each other directly all the same.
target_compile_options(lippmann_options INTERFACE -fPIC $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)

if(LIPPMANN_WERROR)
  target_compile_options(lippmann_options INTERFACE -Werror)
endif()
if(LIPPMANN_ASSERTS)
  string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")
endif()
if(LIPPMANN_SANITIZE)
  target_compile_options(lippmann_options INTERFACE -fsanitize=${LIPPMANN_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(lippmann_options INTERFACE -fsanitize=${LIPPMANN_SANITIZE})
  # Resolvers of function clones run before a sanitizer's run-time is up.
  target_compile_definitions(lippmann_options INTERFACE LIPPMANN_NO_MULTIVERSION)
endif()

# lippmann_may_join(TARGET): with LIPPMANN_UNITY, the sources of TARGET are compiled twelve at a time, which reads each header once
# for all of them. A file of twelve is not so long that the last one to compile holds up the others.
function(lippmann_may_join target)
  if(LIPPMANN_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # GCC takes the joined files for headers, in which members of types of unnamed namespaces would be a mistake.
      target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endif()
  endif()
endfunction()

# lippmann_part(NAME SOURCES ... DEPENDS ... PRIVATE_DEPENDS ...): the static library lippmann_NAME, alias lippmann::NAME.
function(lippmann_part name)
  cmake_parse_arguments(PART "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(lippmann_${name} STATIC ${PART_SOURCES})
  add_library(lippmann::${name} ALIAS lippmann_${name})
  set_property(GLOBAL APPEND PROPERTY LIPPMANN_PARTS ${name})
  target_link_libraries(lippmann_${name} PUBLIC lippmann_options ${PART_DEPENDS} PRIVATE ${PART_PRIVATE_DEPENDS})
  lippmann_use_precompiled(lippmann_${name} lippmann_common_headers)
  # Clang refuses to make versions of a function (core/multiversion.hpp) that an earlier source of the joined file calls.
  # Sanitizers and Clang before 19 build no versions.
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang" OR CMAKE_CXX_COMPILER_VERSION VERSION_LESS 19 OR LIPPMANN_SANITIZE)
    lippmann_may_join(lippmann_${name})
  endif()
endfunction()

set(LIPPMANN_TEST_TIMEOUT 300)
if(LIPPMANN_SANITIZE)
  set(LIPPMANN_TEST_TIMEOUT 3000)
endif()

# lippmann_optimise_tests(TARGET [COMPUTES]): much of a test's code runs once, so that what counts is how long it takes to compile;
# some of it computes a little. What is tested is compiled as ever.
function(lippmann_optimise_tests target)
  cmake_parse_arguments(TEST "COMPUTES" "" "" ${ARGN})
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:$<IF:$<BOOL:${TEST_COMPUTES}>,-O1,-O0>>)
endfunction()

# lippmann_test(NAME [QUICK] [COMPUTES] [SOURCES ...] DEPENDS ...): one GoogleTest program, of all *_test.cpp of the folder unless
# SOURCES are given.
# QUICK: all its tests together take seconds at most. ctest runs the program once, under its name and the label quick; of other
# programs, ctest knows each test under its own name.
# COMPUTES: its own code takes time, to look at many pixels, say.
function(lippmann_test name)
  cmake_parse_arguments(TEST "QUICK;COMPUTES" "" "SOURCES;DEPENDS" ${ARGN})
  if(NOT TEST_SOURCES)
    file(GLOB TEST_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cpp)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE lippmann_test_support ${TEST_DEPENDS} GTest::gmock GTest::gtest_main)
  if(TEST_COMPUTES)
    lippmann_optimise_tests(${name} COMPUTES)
    lippmann_use_precompiled(${name} lippmann_computing_test_headers)
  else()
    lippmann_optimise_tests(${name})
    lippmann_use_precompiled(${name} lippmann_test_headers)
  endif()
  lippmann_may_join(${name})
  if(TEST_QUICK)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS quick TIMEOUT ${LIPPMANN_TEST_TIMEOUT})
  else()
    # A loaded machine may take far longer than the 5 s that CMake gives a program to list its tests.
    # Values of parameters do not become parts of names: structs are printed as bytes, pointers among them.
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 NO_PRETTY_VALUES
      PROPERTIES TIMEOUT ${LIPPMANN_TEST_TIMEOUT})
  endif()
endfunction()
