# Writes the revision of the sources, if it is another one than before.
# cmake -D SOURCE_DIR=... -D OUTPUT=... -P revision.cmake
set(revision unknown)
# A copy of the sources inside another project's clone has no revision of its own.
if(EXISTS ${SOURCE_DIR}/.git)
  execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --tags
                  OUTPUT_VARIABLE described RESULT_VARIABLE failed ERROR_QUIET
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT failed)
    set(revision ${described})
  endif()
endif()
set(text "#include \"tools/commands/revision.hpp\"

namespace wavecurve::tools {

const char* const revision = \"${revision}\";

}  // namespace wavecurve::tools
")
set(before "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT text STREQUAL before)
  file(WRITE ${OUTPUT} "${text}")
endif()
