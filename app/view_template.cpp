#include "app/view_template.h"

#include <string_view>
#include <system_error>

#include "io/files/error.h"
#include "io/files/gzip.h"
#include "io/files/plain_file.h"
#include "io/files/text_file.h"
#include "io/json/json_text.h"
#include "reports/markup/pictures.h"

namespace sturm {

namespace {

constexpr std::string_view view_element = R"(<script id="sturm-view" type="application/json">null</script>)";
constexpr std::string_view scene_element = R"(<script id="sturm-scene" type="text/plain"></script>)";

/// Texts that stand within a script element must not look like its end, or like a comment.
std::string within_script(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

void replace_once(std::string& page, std::string_view element, const std::string& content, std::string_view before) {
  const std::size_t at = page.find(element);
  page.replace(at, element.size(), std::string(before) + content + "</script>");
}

bool has_once(const std::string& page, std::string_view element) {
  const std::size_t at = page.find(element);
  return at != std::string::npos && page.find(element, at + 1) == std::string::npos;
}

std::filesystem::path found_template() {
  std::error_code code;
  const std::filesystem::path bin = std::filesystem::read_symlink("/proc/self/exe", code).parent_path();
  for (const std::filesystem::path place : {"../share/sturm/viewer/viewer.html", "../../viewer/viewer.html"}) {
    const std::filesystem::path file = (bin / place).lexically_normal();
    if (std::filesystem::is_regular_file(file, code)) return file;
  }
  throw InputError("", "--template", "nothing",
                   "the viewer's page, which was not built: scripts/viewer builds it (or give its file)");
}

}  // namespace

std::string view_template(const std::string& given) {
  const std::filesystem::path file = given.empty() ? found_template() : std::filesystem::path(given);
  require_plain_file(file, "the viewer's page without data, as scripts/viewer builds it");
  std::string page = file_contents(file).value_or("");
  if (!has_once(page, view_element) || !has_once(page, scene_element))
    throw InputError(file.string(), "", "a file without the places for a view and a scene",
                     "the viewer's page without data, as scripts/viewer builds it");
  return page;
}

std::string filled_page(std::string page, const PageData& data) {
  const std::string packed = gzip(data.scene);
  replace_once(page, view_element, within_script(json_text(data.view)),
               R"(<script id="sturm-view" type="application/json">)");
  replace_once(page, scene_element, base64({packed.begin(), packed.end()}),
               R"(<script id="sturm-scene" type="text/plain">)");
  return page;
}

}  // namespace sturm
