#include "app/name_of_text.h"

#include "io/files/error.h"
#include "io/files/plain_file.h"

namespace sturm {

void require_name_of_text(const std::filesystem::path& output) {
  for (const char* suffix :
       {".exr", ".hdr", ".pfm", ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".svg", ".pdf", ".html", ".mp4"})
    if (has_suffix(output, suffix))
      throw InputError(output.string(), "", "the name of a picture or a page for a text",
                       "a name for JSON or a table, such as " +
                           std::filesystem::path(output.filename()).replace_extension(".json").string());
}

}  // namespace sturm
