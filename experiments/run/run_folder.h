#pragma once
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// The output folder of a run. Finished parts are kept in parts/<key>/, where the key stands for the resolved spec, the
/// program and the contents of all inputs: a part of another run is never taken for one of this run.
class RunFolder {
 public:
  /// What a run writes into its folder besides the parts.
  struct Layout {
    std::vector<std::string> reports;  ///< files that appear when the run is complete; the first one last
    std::vector<std::string> folders;
  };

  /// Prepares `folder`: old reports and parts of other runs go away; parts of this run stay only if `resume`.
  /// Throws RuntimeFailure where the folder cannot be written.
  RunFolder(std::filesystem::path folder, const std::string& key, bool resume, const Layout& layout);

  const std::filesystem::path& path() const { return folder_; }

  /// The finished part of this name, if it and its pictures are there; else the result of `make`, stored before it is
  /// returned. `reused` tells which.
  struct Part {
    Json value;
    bool reused;
  };
  Part part(const std::string& name, const std::function<Json()>& make) const;

 private:
  std::filesystem::path folder_, parts_;
};

}  // namespace sturm
