#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/json/schema.h"
#include "reports/page/bench_page.h"
#include "reports/page/run_page.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

/// A kind of report that has a page.
struct StoredReport {
  const char *schema, *file, *page;  ///< the files' names in a run folder
  std::string (*draw)(const Json& report, const fs::path& run_folder);
};

std::string drawn_run(const Json& report, const fs::path& run_folder) {
  return render_report_html(report, run_folder);
}

constexpr StoredReport stored_reports[] = {{"report", "report.json", "report.html", drawn_run},
                                           {"bench_report", "bench.json", "bench.html", bench_report_html}};

/// The report itself, or the one that a run folder has. Throws InputError.
fs::path report_of(const std::string& run) {
  if (!fs::is_directory(run)) return run;
  for (const StoredReport& kind : stored_reports)
    if (const fs::path file = fs::path(run) / kind.file; fs::exists(file)) return file;
  throw InputError(run, "", "no report.json, no bench.json", "the folder of a run that has finished");
}

const StoredReport& kind_of(const Json& report, const std::string& file) {
  const std::string schema = format_of(report, file);
  for (const StoredReport& kind : stored_reports)
    if (kind.schema == schema) return kind;
  throw InputError(file, "/format", report.at("format").dump(), "sturm.report/1 or sturm.bench_report/1");
}

}  // namespace

int report_command(const std::string& run, const std::string& output) {
  const fs::path file = report_of(run);
  const Json report = load_json(file.string());
  const StoredReport& kind = kind_of(report, file.string());
  validate(report, kind.schema, file.string());
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const fs::path page = output.empty() ? folder / kind.page : fs::path(output);
  write_file_atomically(page, kind.draw(report, folder));
  std::cout << "Report: " << page.string() << "\n";
  return 0;
}

}  // namespace sturm
