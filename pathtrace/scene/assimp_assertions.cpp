#include "pathtrace/scene/assimp_assertions.h"

#include <stdexcept>
#include <string>

namespace Assimp {

/// Debian's Assimp checks some files by assertions, which would end the program. This takes the place of its function;
/// Assimp catches the exception and says that it cannot read the file.
[[noreturn]] void aiAssertViolation(const char* condition, const char*, int) {
  throw std::runtime_error(std::string("Assimp's condition \"") + condition + "\" does not hold");
}

}  // namespace Assimp

namespace sturm {

void let_assimp_assert_by_exception() {}

}  // namespace sturm
