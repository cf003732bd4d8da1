#include "io/json/unique_ids.h"

#include <nlohmann/json.hpp>
#include <set>

namespace sturm {

void require_unique_ids(const Json& list, const Source& where) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!ids.insert(list[i]["id"].get<std::string>()).second)
      (where / i / "id").fail(list[i]["id"], "an id that no other entry of this list has");
}

}  // namespace sturm
