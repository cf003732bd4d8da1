#pragma once
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace sturm::test {

/// What is wrong with `page` as well-formed markup: tags that do not match, attributes without quotes, ids that occur
/// twice. "" if nothing.
inline std::string markup_defects(const std::string& page) {
  std::vector<std::string> open;
  std::set<std::string> ids;
  std::string defects;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at)) {
    if (page.compare(at, 9, "<![CDATA[") == 0) {
      at = page.find("]]>", at);
      if (at == std::string::npos) return defects + "a CDATA section is not closed\n";
      continue;
    }
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return defects + "a tag is not closed\n";
    std::string tag = page.substr(at + 1, end - at - 1);
    at = end + 1;
    if (tag[0] == '!') continue;
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1))
        return defects + "</" + tag.substr(1) + "> closes " + (open.empty() ? "nothing" : open.back()) + "\n";
      open.pop_back();
      continue;
    }
    const bool empty = tag.back() == '/';
    if (empty) tag.pop_back();
    static const std::regex whole(R"(^([a-zA-Z][a-zA-Z0-9]*)(\s+[a-zA-Z0-9:-]+\s*=\s*("[^"<]*"|'[^'<]*'))*\s*$)");
    static const std::regex id(R"(\sid\s*=\s*["']([^"']*)["'])");
    std::smatch match;
    // Pictures are long and need no regular expression.
    const bool picture = tag.find("data:image/") != std::string::npos;
    if (!picture && !std::regex_match(tag, match, whole)) defects += "not a tag: <" + tag.substr(0, 80) + ">\n";
    if (!picture && std::regex_search(tag, match, id) && !ids.insert(match[1]).second)
      defects += "id twice: " + match[1].str() + "\n";
    if (!empty) open.push_back(tag.substr(0, tag.find_first_of(" \t\r\n")));
  }
  for (const std::string& tag : open) defects += "<" + tag + "> stays open\n";
  return defects;
}

}  // namespace sturm::test
