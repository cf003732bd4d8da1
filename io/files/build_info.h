#pragma once
#include <string_view>

namespace sturm {

/// What this binary was built from; filled in by the build.
struct BuildInfo {
  std::string_view version;
  std::string_view commit;  ///< abbreviated hash, "+changes" when the tree was not clean, "unknown" outside git
  std::string_view compiler;
  std::string_view build_type;
  std::string_view flags;
  bool native;  ///< compiled for the instruction set of the building machine
};

const BuildInfo& build_info();

}  // namespace sturm
