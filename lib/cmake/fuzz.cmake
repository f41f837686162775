# Fuzzers of everything that reads, where clang and its fuzzer runtime are there: built beside everything else, by
# clang whichever compiler the rest is built with. As tests they try the same inputs every time, for some seconds;
# what has not been tried yet is for tools/fuzz_campaign.py.
#
#   wavecurve_fuzz_object(NAME SOURCE)   compiles a file, instrumented
#   wavecurve_fuzzer(NAME FOLDER DICTIONARY OBJECTS name... LIBRARIES target...)
#       makes and tries FOLDER/fuzz_NAME.cpp with the files of FOLDER/corpus/NAME. Libraries are linked as they
#       are built; of what an instrumented object defines too, that is taken.
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
  function(wavecurve_fuzz_object)
  endfunction()
  function(wavecurve_fuzz_sources)
  endfunction()
  function(wavecurve_fuzzer)
  endfunction()
  return()
endif()

set(WAVECURVE_FUZZ_DIR ${fuzz_dir} CACHE INTERNAL "where fuzzers are built")
set(folders ${EIGEN3_INCLUDE_DIRS} ${LIBXML2_INCLUDE_DIR} ${FLINT_INCLUDE_DIR} ${ARB_INCLUDE_DIR})
list(REMOVE_ITEM folders /usr/include)  # which named would come before the compiler's own
list(REMOVE_DUPLICATES folders)
list(TRANSFORM folders PREPEND -isystem)
set(WAVECURVE_FUZZ_FLAGS
    -std=c++20 -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=undefined
    -I${CMAKE_CURRENT_SOURCE_DIR} -I${PROJECT_SOURCE_DIR} ${folders}
    CACHE INTERNAL "how they are compiled")
set(WAVECURVE_FUZZ_LIBRARIES -lhwy ${ARB_LIBRARY} ${FLINT_LIBRARY} ${MPFR_LIBRARY} ${GMP_LIBRARY} -lxml2 -lpng -lz
    -lpolyclipping -lfmt
    CACHE INTERNAL "what they are linked with")
add_custom_target(fuzzers ALL)

function(wavecurve_fuzz_object name source)
  set(object ${WAVECURVE_FUZZ_DIR}/${name}.o)
  add_custom_command(
    OUTPUT ${object}
    COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${WAVECURVE_CLANG} ${WAVECURVE_FUZZ_FLAGS} -fsanitize=fuzzer-no-link
            -MD -MF ${WAVECURVE_FUZZ_DIR}/${name}.d -c ${source} -o ${object}
    DEPENDS ${source} DEPFILE ${WAVECURVE_FUZZ_DIR}/${name}.d
    COMMENT "Building the fuzzed ${name}" VERBATIM)
endfunction()

# An instrumented library has another sanitizer's runtime; what needs libraries is then left out.
function(wavecurve_fuzzer name folder dictionary)
  cmake_parse_arguments(FUZZ "" "" "OBJECTS;LIBRARIES" ${ARGN})
  if(FUZZ_LIBRARIES AND WAVECURVE_SANITIZE)
    return()
  endif()
  set(fuzzer ${WAVECURVE_FUZZ_DIR}/fuzz_${name})
  wavecurve_fuzz_object(fuzz_${name} ${folder}/fuzz_${name}.cpp)
  set(objects ${fuzzer}.o)
  foreach(object IN LISTS FUZZ_OBJECTS)
    list(APPEND objects ${WAVECURVE_FUZZ_DIR}/${object}.o)
  endforeach()
  set(archives "")
  foreach(target IN LISTS FUZZ_LIBRARIES)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL OBJECT_LIBRARY)
      # What is precompiled is among them.
      list(APPEND archives "$<FILTER:$<TARGET_OBJECTS:${target}>,EXCLUDE,gch$>")
    else()
      list(APPEND archives $<TARGET_FILE:${target}>)
    endif()
  endforeach()
  add_custom_command(
    OUTPUT ${fuzzer}
    COMMAND ${WAVECURVE_CLANG} -fsanitize=fuzzer,address,undefined -Wl,--allow-multiple-definition ${objects}
            -Wl,--start-group ${archives} -Wl,--end-group ${WAVECURVE_FUZZ_LIBRARIES} -o ${fuzzer}
    DEPENDS ${objects} ${FUZZ_LIBRARIES} ${archives} COMMENT "Linking fuzz_${name}"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(fuzzer_${name} DEPENDS ${fuzzer})
  add_dependencies(fuzzers fuzzer_${name})
  set(found ${WAVECURVE_FUZZ_DIR}/found/${name})
  file(MAKE_DIRECTORY ${WAVECURVE_FUZZ_DIR}/found)
  # Files, not their folder, to which the fuzzer would write what reaches something new.
  file(GLOB seeds CONFIGURE_DEPENDS ${folder}/corpus/${name}/*)
  list(JOIN seeds "," seeds)
  add_test(NAME fuzz.${name}
           COMMAND ${fuzzer} -seed=1 -runs=20000 -max_total_time=5 -max_len=4096 -timeout=10 -verbosity=0
                   -dict=${dictionary} -artifact_prefix=${found}- -seed_inputs=${seeds})
  set_tests_properties(fuzz.${name} PROPERTIES COST 10)
endfunction()

# Sources as one file, but for what takes long by itself.
function(wavecurve_fuzz_sources name)
  list(TRANSFORM ARGN PREPEND "#include \"")
  list(TRANSFORM ARGN APPEND "\"\n")
  list(JOIN ARGN "" includes)
  file(CONFIGURE OUTPUT ${WAVECURVE_FUZZ_DIR}/${name}.cpp CONTENT "${includes}" @ONLY)
  wavecurve_fuzz_object(${name} ${WAVECURVE_FUZZ_DIR}/${name}.cpp)
endfunction()

# The readers of drawings in two parts: SVG's grammars, which take as long as all else, and the rest.
set(room ${CMAKE_CURRENT_SOURCE_DIR}/wavecurve)
file(GLOB readers CONFIGURE_DEPENDS ${room}/io/drawings/detail/svg/*.cpp)
list(FILTER readers EXCLUDE REGEX "_test\\.cpp$|svg_values\\.cpp$")
wavecurve_fuzz_sources(readers ${readers} ${room}/io/drawings/detail/read_points.cpp
                       ${room}/io/drawings/detail/stroke_polygons.cpp
                       ${room}/io/drawings/detail/point_columns.cpp ${room}/io/files/detail/table_rows.cpp
                       ${room}/io/tracks/detail/track_table.cpp ${room}/io/tracks/detail/wide_table.cpp
                       ${room}/io/tracks/detail/joint_name.cpp ${room}/io/files/detail/csv.cpp
                       ${room}/io/files/detail/text.cpp
                       ${room}/filters/detail/bad_value.cpp ${room}/filters/detail/characters.cpp)
wavecurve_fuzz_object(svg_values ${room}/io/drawings/detail/svg/svg_values.cpp)
foreach(reader IN ITEMS svg csv tracks)
  wavecurve_fuzzer(${reader} ${fuzz_source} ${fuzz_source}/svg.dict OBJECTS readers svg_values
                   LIBRARIES wavecurve)
endforeach()

wavecurve_fuzz_sources(json_readers ${room}/io/filter_json.cpp ${room}/io/descriptor_json.cpp
                       ${room}/io/tracks/gait_parameters_json.cpp
                       ${room}/io/files/detail/json_place.cpp ${room}/io/files/detail/parse_json.cpp)
foreach(reader IN ITEMS filter descriptor gait)
  wavecurve_fuzzer(${reader} ${fuzz_source} ${fuzz_source}/json.dict OBJECTS json_readers
                   LIBRARIES wavecurve_io wavecurve_certified wavecurve)
endforeach()
