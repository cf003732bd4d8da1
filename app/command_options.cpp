#include "app/command_options.h"

#include "io/files/build_info.h"
#include "io/files/sandbox.h"
#include "io/json/manifest.h"

namespace sturm {

namespace {

std::string version_text() {
  const BuildInfo& b = build_info();
  return "sturm " + std::string(b.version) + " (commit " + std::string(b.commit) + ")\nbuilt with " +
         std::string(b.compiler) + ", " + std::string(b.build_type) + ", flags " + std::string(b.flags) +
         "\ninstruction set " + instruction_set() + "\n";
}

}  // namespace

void add_document(CLI::App& command, CommonOptions& options, const char* what) {
  command.add_option("file", options.file, std::string(what) + " (- is standard input)")->required();
  command.add_option("--set", options.assignments, "change the configuration: /json/pointer=value; may be repeated")
      ->allow_extra_args(false);
}

void add_prescription(CLI::App& command, CommonOptions& options, const char* whose) {
  command.add_option("--rx", options.prescription,
                     std::string("prescription of ") + whose + ", in place of the document's: \"-2.00 -1.50 x 30\"");
}

void add_run_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--seed", options.seed, "seed of all random numbers");
  command.add_option("--threads", options.threads, "threads to use; 0 = one per processor")->check(CLI::Range(0, 1024));
  command.add_flag("--quiet", options.quiet, "no progress on stderr");
}

void add_common_options(CLI::App& command, CommonOptions& options, const char* what) {
  add_document(command, options, what);
  add_run_options(command, options);
}

CommandLine::CommandLine() {
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  app.add_flag_callback("--sandbox", enter_sandbox,
                        "for files that are not trusted: each may name only files in its own folder and below");
  add_run();
  add_ellipse();
  add_lens();
  add_plot();
  add_wearers();
  add_validate_camera();
  add_blurfield();
  add_psf();
  add_wavefront();
  add_render();
  add_see();
  add_bench();
  add_stress();
  add_compare();
  add_compare_runs();
  add_plan_samples();
  add_gate();
  add_report();
  add_validate();
  add_schema();
  for (CLI::App* command : app.get_subcommands({})) command->fallthrough();
}

void CommandLine::add_validate() {
  auto* validate = app.add_subcommand("validate", "check a configuration without running it");
  validate->add_option("file", file, "any document of Sturm (- is standard input)")->required();
  validate->callback([this] { action = [this] { return validate_command(file); }; });
}

void CommandLine::add_schema() {
  auto* schema_app = app.add_subcommand("schema", "print a JSON schema, or the names of all");
  schema_app->add_option("name", schema, "e.g. experiment");
  schema_app->callback([this] { action = [this] { return schema_command(schema); }; });
}

}  // namespace sturm
