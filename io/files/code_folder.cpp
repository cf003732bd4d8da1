#include "io/files/code_folder.h"

#include <dlfcn.h>
#include <link.h>

namespace sturm {

std::filesystem::path folder_of_this_code() {
  Dl_info info{};
  void* extra = nullptr;
  const void* here = reinterpret_cast<const void*>(&folder_of_this_code);
  if (dladdr1(here, &info, &extra, RTLD_DL_LINKMAP) == 0 || !extra) return {};
  const char* library = static_cast<const link_map*>(extra)->l_name;
  std::error_code code;
  if (library && *library) return std::filesystem::canonical(library, code).parent_path();
  return std::filesystem::read_symlink("/proc/self/exe", code).parent_path();  // the program itself has no name there
}

}  // namespace sturm
