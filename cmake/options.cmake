add_library(lippmann_options INTERFACE)
target_include_directories(lippmann_options INTERFACE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
target_compile_options(lippmann_options INTERFACE -Wall -Wextra -Wshadow -Wno-unknown-pragmas)
# Allow designated initialisers that leave other members at their defaults.
target_compile_options(lippmann_options INTERFACE -Wno-missing-field-initializers)
# GCC warns that the ABI of vectors passed by value depends on the instruction set. The library's interface has no such vectors.
target_compile_options(lippmann_options INTERFACE -Wno-psabi)
# GCC's -Wdangling-reference is wrong for functions that take a temporary and return a reference to another object.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13 AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 14)
  target_compile_options(lippmann_options INTERFACE -Wno-dangling-reference)
endif()
# Loops over lanes combine bools by & and |, because && and || would branch and prevent vectorisation.
target_compile_options(lippmann_options INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)

# Clang 19 and later omit constructors that only function versions (core/multiversion.hpp) call, unless this is set.
target_compile_options(lippmann_options INTERFACE
  $<$<AND:$<COMPILE_LANG_AND_ID:CXX,Clang>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,19>>:SHELL:-Xclang -mno-constructor-aliases>)

# FMA contraction is off, so that all versions of a function (core/multiversion.hpp) give the same bits. Without errno and
# floating-point traps, the compiler vectorises floor, sqrt and selects.
target_compile_options(lippmann_options INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)

# Parts are also linked into a shared library (library.cmake), which requires -fPIC. With -fno-semantic-interposition,
# functions of the library still call each other directly.
target_compile_options(lippmann_options INTERFACE -fPIC $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)

if(LIPPMANN_WERROR)
  target_compile_options(lippmann_options INTERFACE -Werror)
endif()
if(LIPPMANN_ASSERTS)
  string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")
endif()
if(LIPPMANN_SANITIZE)
  target_compile_options(lippmann_options INTERFACE -fsanitize=${LIPPMANN_SANITIZE} -fno-omit-frame-pointer)
  if(LIPPMANN_FUZZERS)
    # In the code of tests, only AddressSanitizer looks for errors. All sanitizers together double the compile time of tests.
    target_compile_options(lippmann_options INTERFACE
      $<$<BOOL:$<TARGET_PROPERTY:LIPPMANN_IS_TEST>>:-fno-sanitize=fuzzer-no-link,undefined>)
  endif()
  target_link_options(lippmann_options INTERFACE -fsanitize=${LIPPMANN_SANITIZE})
  # Sanitizers cannot be combined with function versions: their resolvers run before the sanitizer's run-time has started.
  target_compile_definitions(lippmann_options INTERFACE LIPPMANN_NO_MULTIVERSION)
endif()

# lippmann_may_join(TARGET): with LIPPMANN_UNITY, joins every twelve sources of TARGET in one file. Larger groups would leave
# processors idle while the last group is compiled.
function(lippmann_may_join target)
  if(LIPPMANN_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # GCC warns of members with types of unnamed namespaces in included files, and treats joined sources like included files.
      target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endif()
  endif()
endfunction()

# lippmann_part(NAME SOURCES ... DEPENDS ... PRIVATE_DEPENDS ...): declares the static library lippmann_NAME and its alias
# lippmann::NAME.
function(lippmann_part name)
  cmake_parse_arguments(PART "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(lippmann_${name} STATIC ${PART_SOURCES})
  add_library(lippmann::${name} ALIAS lippmann_${name})
  set_property(GLOBAL APPEND PROPERTY LIPPMANN_PARTS ${name})
  target_link_libraries(lippmann_${name} PUBLIC lippmann_options ${PART_DEPENDS} PRIVATE ${PART_PRIVATE_DEPENDS})
  lippmann_use_precompiled(lippmann_${name} lippmann_common_headers)
  # Clang cannot compile several versions of a function (core/multiversion.hpp) if an earlier source of a joined file calls it.
  # Builds with sanitizers and builds with Clang before 19 have no function versions.
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang" OR CMAKE_CXX_COMPILER_VERSION VERSION_LESS 19 OR LIPPMANN_SANITIZE)
    lippmann_may_join(lippmann_${name})
  endif()
endfunction()

# lippmann_optimise_little(TARGET): for code that only parses, calls and prints. With -O3, it takes up to 1.7 times as long to compile,
# but runs no faster. Builds of fuzzers do not optimise at all.
function(lippmann_optimise_little target)
  if(NOT LIPPMANN_FUZZERS)
    target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
  endif()
endfunction()

set(LIPPMANN_TEST_TIMEOUT 300)
if(LIPPMANN_SANITIZE)
  set(LIPPMANN_TEST_TIMEOUT 3000)
endif()

# lippmann_optimise_tests(TARGET [COMPUTES]): compiles the code of tests without optimisation, because most of it runs only once.
# COMPUTES enables some optimisation, for tests whose own code takes time.
# Builds of fuzzers compile all tests without optimisation, because their sanitizers make optimisation slow.
function(lippmann_optimise_tests target)
  cmake_parse_arguments(TEST "COMPUTES" "" "" ${ARGN})
  if(LIPPMANN_FUZZERS)
    set(TEST_COMPUTES OFF)
  endif()
  set_target_properties(${target} PROPERTIES LIPPMANN_IS_TEST ON)
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:$<IF:$<BOOL:${TEST_COMPUTES}>,-O1,-O0>>)
endfunction()

# lippmann_test(NAME [QUICK] [COMPUTES] [SOURCES ...] DEPENDS ...): declares a GoogleTest program of SOURCES. Default: all *_test.cpp in
# the folder.
# QUICK: all tests of the program together take a few seconds. ctest runs the program once, under its name and the label quick. Without
# QUICK, ctest runs each test of the program separately.
# COMPUTES: see lippmann_optimise_tests().
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
    # DISCOVERY_TIMEOUT: on a loaded machine, listing the tests of a program may take far longer than CMake's default of 5 s.
    # NO_PRETTY_VALUES: otherwise, test names would contain the bytes of parameters, which include pointers.
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 NO_PRETTY_VALUES
      PROPERTIES TIMEOUT ${LIPPMANN_TEST_TIMEOUT})
  endif()
endfunction()
