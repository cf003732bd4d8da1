#include "io/json/json_text.h"

#include <nlohmann/json.hpp>

namespace sturm {

std::string json_text(const Json& value, int indent) {
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace sturm
