#pragma once
#include <algorithm>
#include <string>
#include <vector>

namespace sturm {

/// Adds the files of `more` that are not yet in `files`.
inline void add_files(std::vector<std::string>& files, const std::vector<std::string>& more) {
  for (const std::string& file : more)
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
}

}  // namespace sturm
