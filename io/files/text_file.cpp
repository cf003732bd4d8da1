#include "io/files/text_file.h"

#include <fstream>
#include <iterator>

namespace sturm {

std::optional<std::string> file_contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  // A directory can be opened, but not read.
  if (!stream || std::filesystem::is_directory(file)) return std::nullopt;
  if (std::filesystem::is_regular_file(file)) {
    std::string bytes(std::filesystem::file_size(file), '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    if (!bytes.empty()) return bytes;
    stream.clear();  // files of the system have no size before they are read
  }
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

}  // namespace sturm
