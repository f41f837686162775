# Runs an example: it must succeed, and print the lines "//   ..." of its opening comment.
# cmake -D SOURCE=example.cpp "-DCOMMAND=program;arguments" -P check_example.cmake
file(STRINGS ${SOURCE} shown REGEX "^//   ")
list(TRANSFORM shown REPLACE "^//   " "")
list(JOIN shown "\n" shown)
execute_process(COMMAND ${COMMAND} OUTPUT_VARIABLE printed ERROR_VARIABLE complaint RESULT_VARIABLE result
                OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${COMMAND} ended with ${result}: ${complaint}")
endif()
if(NOT shown OR NOT printed STREQUAL shown)
  message(FATAL_ERROR "${SOURCE} says\n${shown}\nbut the program prints\n${printed}")
endif()
