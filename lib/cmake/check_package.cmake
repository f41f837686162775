# Installs the build into a prefix of its own, then configures, builds and runs a user's project with it.
# cmake -D BUILD_DIR=... -D WORK_DIR=... -D CONFIG=... -D CXX=... -P check_package.cmake
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix --config ${CONFIG}
    --component library)
run(${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_LIST_DIR}/consumer ${WORK_DIR}/build
    --build-generator Ninja --build-options
    -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_COMPILER=${CXX}
    --test-command ${CMAKE_CTEST_COMMAND} --output-on-failure)
