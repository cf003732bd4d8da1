// The page has no files: lenses in the trade's formats and measured surfaces are refused here in place of their
// readers, and no document is shipped with it.
#include "io/files/error.h"
#include "io/files/shipped_files.h"
#include "io/specs/lens_files/lens_file.h"
#include "io/specs/sag_grid.h"

namespace sturm {

namespace {

[[noreturn]] void refuse(const std::string& file) {
  throw InputError(file, "", "a lens in a file of its own",
                   "a lens that is stated in the document: sturm view reads such files");
}

}  // namespace

bool is_lens_file(std::string_view) {
  return false;
}

LensFile read_lens_file(const LensFileRequest& request) {
  refuse(request.file);
}

SagGrid read_sag_grid(const std::string& file, std::optional<double>, double) {
  refuse(file);
}

std::vector<std::string> shipped_names(const std::string&) {
  return {};
}

std::optional<std::filesystem::path> shipped_document(const std::string&, const std::string&) {
  return std::nullopt;
}

std::optional<std::filesystem::path> shipped_counterpart(const std::filesystem::path&) {
  return std::nullopt;
}

}  // namespace sturm
