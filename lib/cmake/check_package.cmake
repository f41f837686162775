# Installs the build into a prefix of its own; then builds the examples with it, as a user would, and
# runs them, and compiles every installed header by itself.
# cmake -D BUILD_DIR=... -D WORK_DIR=... -D CONFIG=... -D CXX=... -P check_package.cmake
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(build_and_test source folder)
  run(${CMAKE_CTEST_COMMAND} --build-and-test ${source} ${WORK_DIR}/${folder} --build-generator Ninja
      --build-options -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_COMPILER=${CXX}
      ${ARGN})
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix --config ${CONFIG}
    --component library)
build_and_test(${CMAKE_CURRENT_LIST_DIR}/../examples examples
               --test-command ${CMAKE_CTEST_COMMAND} --output-on-failure)
build_and_test(${CMAKE_CURRENT_LIST_DIR}/each_header each_header)
