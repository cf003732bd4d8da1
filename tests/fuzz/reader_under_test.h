#pragma once
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "io/files/error.h"

namespace sturm::fuzz {

/// What a reader gets: the bytes that the fuzzer made up.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Runs a reader. It may refuse its input as wrong, or say that something failed; anything else ends the program.
template <class Reader>
void try_reader(const Reader& reader) {
  try {
    reader();
  } catch (const InputError&) {
  } catch (const RuntimeFailure&) {
  }
}

/// A folder in memory of this process alone, for readers that take files.
inline const std::filesystem::path& folder() {
  static const std::filesystem::path made = [] {
    const auto path = std::filesystem::path("/dev/shm") / ("sturm_fuzz_" + std::to_string(::getpid()));
    std::filesystem::create_directories(path);
    return path;
  }();
  return made;
}

/// The file of this name in that folder, with these bytes.
inline std::filesystem::path written(const std::string& name, std::string_view bytes) {
  const std::filesystem::path file = folder() / name;
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

}  // namespace sturm::fuzz
