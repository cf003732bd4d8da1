#pragma once
#include <string_view>

namespace sturm {

/// What this binary was built from; filled in by the build.
struct BuildInfo {
  std::string_view version;     ///< of the project: "0.1.0"
  std::string_view commit;      ///< abbreviated hash, "+changes" when the tree was not clean, "unknown" outside git
  std::string_view compiler;    ///< its name and version
  std::string_view build_type;  ///< as CMake names it: "Release"
  std::string_view flags;       ///< of the compiler for every C++ file
  bool native;                  ///< compiled for the instruction set of the building machine
};

const BuildInfo& build_info();  ///< of this library; the same object each time

}  // namespace sturm
