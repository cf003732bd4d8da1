# Script mode: writes OUTPUT with the facts of io/files/build_info.h.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git -C ${SOURCE} status --porcelain OUTPUT_VARIABLE dirty OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit "unknown")
elseif(dirty)
  set(commit "${commit}+changes")
endif()
string(REPLACE ";" " " FLAGS "${FLAGS}")
string(STRIP "${FLAGS}" FLAGS)
set(body "// Generated; do not edit.
#include \"io/files/build_info.h\"
namespace sturm {
const BuildInfo& build_info() {
  static const BuildInfo info{\"${VERSION}\", \"${commit}\", \"${COMPILER}\", \"${BUILD_TYPE}\", \"${FLAGS}\", \"${NATIVE}\" == std::string_view(\"ON\")};
  return info;
}
}  // namespace sturm
")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT old STREQUAL body)
  file(WRITE ${OUTPUT} "${body}")
endif()
