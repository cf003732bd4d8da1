#include "viewer/core/errors.h"

#include <emscripten.h>

namespace sturm::viewer {

EM_JS(void, throw_error, (const char* message), { throw new Error(UTF8ToString(message)); });

void throw_to_page(const std::string& message) {
  throw_error(message.c_str());
  __builtin_unreachable();
}

}  // namespace sturm::viewer
