#pragma once
#include <string>

#include "io/io_testing.h"
#include "io/specs/lens_files/lens_file.h"
#include "lensmodel/vertex_power.h"

namespace sturm {

/// Lens files that a test writes.
class LensFileTest : public ::testing::Test {
 protected:
  LensFile lens(const std::string& text, const std::string& name, LensFileRequest request = {}) {
    write_text(folder_ / name, text);
    request.file = (folder_ / name).string();
    return read_lens_file(request);
  }
  std::string error(const std::string& text, const std::string& name, LensFileRequest request = {}) {
    return input_error([&] { lens(text, name, request); });
  }

  static Prescription power(const LensFile& file) { return vertex_power(file.lens).back_vertex->as_prescription(); }

  TemporaryFolder folder_;
};

}  // namespace sturm
