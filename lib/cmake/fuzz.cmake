# Fuzzes the readers of drawings and tracks for half a minute each, as tests, where clang and its
# fuzzer runtime are there. The tests build the fuzzers themselves, beside everything else.
find_program(WAVECURVE_CLANG clang++)
set(fuzz_dir ${CMAKE_CURRENT_BINARY_DIR}/fuzz)
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

set(fuzz_source ${CMAKE_CURRENT_SOURCE_DIR}/wavecurve/io/fuzz)
add_test(NAME fuzz.build
         COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${fuzz_source} ${fuzz_dir}
                 --build-generator Ninja --build-noclean
                 --build-options -DCMAKE_CXX_COMPILER=${WAVECURVE_CLANG})
set_tests_properties(fuzz.build PROPERTIES FIXTURES_SETUP fuzzers)
foreach(reader IN ITEMS svg csv tracks)
  file(MAKE_DIRECTORY ${fuzz_dir}/found/${reader})
  add_test(NAME fuzz.${reader}
           COMMAND ${fuzz_dir}/fuzz_${reader} -max_total_time=30 -max_len=4096 -timeout=10 -verbosity=0
                   -dict=${fuzz_source}/svg.dict -artifact_prefix=${fuzz_dir}/found/${reader}-
                   ${fuzz_dir}/found/${reader} ${fuzz_source}/corpus/${reader})
  set_tests_properties(fuzz.${reader} PROPERTIES FIXTURES_REQUIRED fuzzers)
endforeach()
