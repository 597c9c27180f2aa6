# nearwall_add_module(NAME
#   HEADERS  <public headers, relative to include/nearwall/NAME>
#   SOURCES  <sources without CGAL, relative to the current folder>
#   CGAL_SOURCES <*_cgal.cpp: compiled with CGAL and its rounding flags, always optimised>
#   LINK     <nearwall modules that the public headers of this one use>
#   PRIVATE  <libraries that its sources use>)
#
# Makes the library nearwall_NAME with the alias nearwall::NAME. A module links just what its row in the table of
# docs/development.md names; tests/include_direction_test.py holds every #include against that table.
set(NEARWALL_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)

function(nearwall_set_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Contracted multiply-adds would make results depend on the machine.
  target_compile_options(${target} PRIVATE ${NEARWALL_WARNINGS} -ffp-contract=off
                         $<$<BOOL:${NEARWALL_WARNINGS_AS_ERRORS}>:-Werror>)
  target_compile_definitions(${target} PRIVATE $<$<BOOL:${NEARWALL_CHECKED}>:NEARWALL_CHECKED>)
endfunction()

function(nearwall_add_module name)
  cmake_parse_arguments(ARG "" "" "HEADERS;SOURCES;CGAL_SOURCES;LINK;PRIVATE" ${ARGN})
  set(target nearwall_${name})
  list(TRANSFORM ARG_HEADERS PREPEND "${PROJECT_SOURCE_DIR}/include/nearwall/${name}/" OUTPUT_VARIABLE headers)

  add_library(${target} ${ARG_SOURCES})
  add_library(nearwall::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${headers})
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/src")
  nearwall_set_compile_options(${target})
  list(TRANSFORM ARG_LINK PREPEND "nearwall::" OUTPUT_VARIABLE modules)
  target_link_libraries(${target} PUBLIC ${modules} PRIVATE ${ARG_PRIVATE})

  if(ARG_CGAL_SOURCES)
    add_library(${target}_cgal OBJECT ${ARG_CGAL_SOURCES})
    target_include_directories(${target}_cgal PRIVATE "${PROJECT_SOURCE_DIR}/include" "${PROJECT_SOURCE_DIR}/src")
    nearwall_set_compile_options(${target}_cgal)
    # CGAL is 12 to 60 times slower without optimisation: optimised in every build type.
    target_compile_options(${target}_cgal PRIVATE $<$<CONFIG:Debug>:-O1>)
    target_link_libraries(${target}_cgal PRIVATE CGAL::CGAL TBB::tbb fmt::fmt)
    target_compile_definitions(${target}_cgal PRIVATE CGAL_LINKED_WITH_TBB)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_cgal>)
    target_link_libraries(${target} PRIVATE gmp mpfr TBB::tbb fmt::fmt)
  endif()
  set_property(GLOBAL APPEND PROPERTY NEARWALL_MODULES ${target})
endfunction()
