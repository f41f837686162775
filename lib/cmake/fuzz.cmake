# The fuzzers of the readers of drawings and tracks, where clang and its fuzzer runtime are there: built beside
# everything else, by clang whichever compiler the rest is built with, and run as tests for half a minute each.
find_program(WAVECURVE_CLANG clang++)
set(fuzz_dir ${CMAKE_CURRENT_BINARY_DIR}/fuzz)
set(fuzz_source ${CMAKE_CURRENT_SOURCE_DIR}/wavecurve/io/fuzz)
if(WAVECURVE_CLANG AND NOT DEFINED WAVECURVE_FUZZER_RUNTIME)
  file(WRITE ${fuzz_dir}/probe.cpp
       "extern \"C\" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }\n")
  execute_process(COMMAND ${WAVECURVE_CLANG} -std=c++20 -fsanitize=fuzzer,address,undefined
                          ${fuzz_dir}/probe.cpp -o ${fuzz_dir}/probe
                  RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed)
    set(works OFF)
  else()
    set(works ON)
  endif()
  set(WAVECURVE_FUZZER_RUNTIME ${works} CACHE BOOL "clang++ links with its fuzzer runtime")
endif()
if(NOT WAVECURVE_CLANG OR NOT WAVECURVE_FUZZER_RUNTIME)
  message(STATUS "No clang++ with a fuzzer runtime: the readers are not fuzzed")
  return()
endif()

# The readers in two parts: SVG's grammars, which take as long as all else, and the rest.
set(room ${CMAKE_CURRENT_SOURCE_DIR}/wavecurve)
file(GLOB readers CONFIGURE_DEPENDS ${room}/io/drawings/detail/svg/*.cpp)
list(FILTER readers EXCLUDE REGEX "_test\\.cpp$|svg_values\\.cpp$")
list(APPEND readers ${room}/io/drawings/detail/read_points.cpp ${room}/io/tracks/detail/track_table.cpp
     ${room}/io/files/detail/csv.cpp ${room}/io/files/detail/for_each_line.cpp
     ${room}/io/files/detail/text.cpp
     ${room}/filters/detail/bad_value.cpp)
list(TRANSFORM readers PREPEND "#include \"")
list(TRANSFORM readers APPEND "\"\n")
list(JOIN readers "" includes)
file(CONFIGURE OUTPUT ${fuzz_dir}/readers.cpp CONTENT "${includes}" @ONLY)

set(flags -std=c++20 -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=undefined
          -I${CMAKE_CURRENT_SOURCE_DIR} -isystem ${EIGEN3_INCLUDE_DIRS} -isystem ${LIBXML2_INCLUDE_DIR})
function(fuzz_object name source)
  add_custom_command(
    OUTPUT ${fuzz_dir}/${name}.o
    COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${WAVECURVE_CLANG} ${flags} -fsanitize=fuzzer-no-link -MD
            -MF ${fuzz_dir}/${name}.d -c ${source} -o ${fuzz_dir}/${name}.o
    DEPENDS ${source} DEPFILE ${fuzz_dir}/${name}.d
    COMMENT "Building the fuzzed ${name}" VERBATIM)
endfunction()
fuzz_object(svg_values ${room}/io/drawings/detail/svg/svg_values.cpp)
fuzz_object(readers ${fuzz_dir}/readers.cpp)

foreach(reader IN ITEMS svg csv tracks)
  set(fuzzer ${fuzz_dir}/fuzz_${reader})
  fuzz_object(fuzz_${reader} ${fuzz_source}/fuzz_${reader}.cpp)
  set(objects ${fuzzer}.o ${fuzz_dir}/readers.o ${fuzz_dir}/svg_values.o)
  add_custom_command(
    OUTPUT ${fuzzer}
    COMMAND ${WAVECURVE_CLANG} -fsanitize=fuzzer,address,undefined ${objects} -lfmt -lxml2 -o ${fuzzer}
    DEPENDS ${objects} COMMENT "Linking fuzz_${reader}" VERBATIM)
  list(APPEND fuzzers ${fuzzer})
  file(MAKE_DIRECTORY ${fuzz_dir}/found/${reader})
  add_test(NAME fuzz.${reader}
           COMMAND ${fuzzer} -max_total_time=30 -max_len=4096 -timeout=10 -verbosity=0
                   -dict=${fuzz_source}/svg.dict -artifact_prefix=${fuzz_dir}/found/${reader}-
                   ${fuzz_dir}/found/${reader} ${fuzz_source}/corpus/${reader})
  set_tests_properties(fuzz.${reader} PROPERTIES COST 30)  # started first, since they take longest
endforeach()
add_custom_target(fuzzers ALL DEPENDS ${fuzzers})
