#include "io/files/text_file.h"

#include <fstream>
#include <iterator>

namespace sturm {

std::optional<std::string> file_contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  // A directory can be opened, but not read.
  if (!stream || std::filesystem::is_directory(file)) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

}  // namespace sturm
