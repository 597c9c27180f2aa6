# nearwall_add_test(NAME SOURCES <files> LINK <libraries> [LABELS unit|property|case|slow])
# One GoogleTest program for each module: NAME_tests. A program without a test is an error.
include(GoogleTest)

function(nearwall_add_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;LABELS" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  add_executable(${name}_tests ${ARG_SOURCES})
  nearwall_set_compile_options(${name}_tests)
  target_include_directories(${name}_tests PRIVATE "${PROJECT_SOURCE_DIR}/src" "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name}_tests PRIVATE ${ARG_LINK} GTest::gtest_main GTest::gmock fmt::fmt)
  gtest_discover_tests(${name}_tests TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 120
                       PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 600)
endfunction()
