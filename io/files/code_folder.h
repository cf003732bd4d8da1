#pragma once
#include <filesystem>

namespace sturm {

/// The folder of the file that holds this code: of the program, or of the shared library that a program has loaded it
/// from. Empty where the system does not say.
std::filesystem::path folder_of_this_code();

}  // namespace sturm
