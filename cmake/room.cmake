# croquis_room(NAME
#   USES rooms...        the rooms whose headers this room may include (tools/check_layers.mjs holds it to that)
#   SOURCES files...     beside the room's CMakeLists.txt
#   TESTS files...       under tests/NAME/
#   LINKS targets...     libraries from outside)
# makes the library croquis_NAME (croquis::NAME) and the test program NAME_test.
function(croquis_room name)
  cmake_parse_arguments(PARSE_ARGV 1 ROOM "" "" "USES;SOURCES;TESTS;LINKS")
  add_library(croquis_${name} STATIC ${ROOM_SOURCES})
  add_library(croquis::${name} ALIAS croquis_${name})
  target_link_libraries(croquis_${name} PUBLIC croquis_flags ${ROOM_LINKS})
  target_precompile_headers(croquis_${name} REUSE_FROM croquis_precompiled)
  foreach(used IN LISTS ROOM_USES)
    target_link_libraries(croquis_${name} PUBLIC croquis::${used})
  endforeach()
  if(CROQUIS_TESTS AND ROOM_TESTS)
    list(TRANSFORM ROOM_TESTS PREPEND ${PROJECT_SOURCE_DIR}/tests/${name}/)
    croquis_test(${name}_test SOURCES ${ROOM_TESTS} LINKS croquis::${name})
  endif()
endfunction()

# croquis_test(NAME SOURCES files... LINKS targets...) makes one GoogleTest program and registers it with CTest.
function(croquis_test name)
  cmake_parse_arguments(PARSE_ARGV 1 TEST "" "" "SOURCES;LINKS")
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE ${TEST_LINKS} croquis_test_support)
  target_precompile_headers(${name} REUSE_FROM croquis_precompiled)
  if(EMSCRIPTEN)
    target_link_options(${name} PRIVATE -sNODERAWFS=1 -sEXIT_RUNTIME=1)
  endif()
  add_test(NAME ${name} COMMAND ${name})
  # Where ctest has no times of earlier runs, long tests go first: as a rule those of many files.
  list(LENGTH TEST_SOURCES files)
  set_tests_properties(${name} PROPERTIES COST ${files})
endfunction()
