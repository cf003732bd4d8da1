#pragma once
#include <filesystem>

namespace sturm {

/// What a name for an output stands for, links followed.
struct OutputTarget {
  enum class Kind {
    File,        ///< a plain file, or nothing yet: it can be replaced
    Node,        ///< a FIFO or a character device: it can only be written to
    Descriptor,  ///< something that this process has open already: /dev/stdout, /dev/fd/3
  };
  Kind kind = Kind::File;
  std::filesystem::path file;  ///< of a file or node: its own name behind all links
  int descriptor = -1;
};

/// Follows symbolic links, those that lead nowhere yet, too. Throws RuntimeFailure for what nothing can be written to:
/// folders, sockets, block devices (a picture would overwrite a disk), links in a circle.
OutputTarget output_target(const std::filesystem::path& path);

}  // namespace sturm
