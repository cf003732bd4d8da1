#include <algorithm>
#include <nlohmann/json.hpp>

#include "stages/plan/render_plan.h"

namespace sturm {

namespace {

const char* state(const PlanItem& item) {
  return item.left_out() ? "left out" : item.switched_on ? "needed" : "done (off)";
}

const char* effect(const PlanItem& item) {
  return item.needless ? name_of(item.claim) : "";
}

}  // namespace

Json plan_json(const WorkPlan& plan) {
  Json list = Json::array();
  for (const PlanItem& item : plan) {
    Json entry = {{"item", item.name},
                  {"left_out", item.left_out()},
                  {"needed", !item.needless},
                  {"reason", item.finding},
                  {"saved", item.saved}};
    if (item.needless) entry["picture"] = name_of(item.claim);
    if (!item.view.empty()) entry["view"] = item.view;
    list.push_back(std::move(entry));
  }
  return list;
}

std::string plan_table(const WorkPlan& plan) {
  std::vector<std::vector<std::string>> rows{{"item", "view", "work", "picture", "reason"}};
  for (const PlanItem& item : plan) rows.push_back({item.name, item.view, state(item), effect(item), item.finding});
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  const bool pair = std::any_of(plan.begin(), plan.end(), [](const PlanItem& item) { return !item.view.empty(); });
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k == 1 && !pair) continue;
      line += row[k];
      if (k + 1 < row.size()) line += std::string(widths[k] + 2 - row[k].size(), ' ');
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace sturm
