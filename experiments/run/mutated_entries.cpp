#include "experiments/run/mutated_entries.h"

#include <nlohmann/json.hpp>

namespace sturm {

Json honest_entries(Json entries) {
  for (Json& entry : entries) entry.erase("mutated");
  return entries;
}

Json mutated_entries(Json entries, const std::string& mutation) {
  for (Json& entry : entries)
    if (entry.contains("mutated") && entry["mutated"].contains(mutation)) {
      Json other = std::move(entry["mutated"][mutation]);
      entry = std::move(other);
    }
  return honest_entries(std::move(entries));
}

}  // namespace sturm
