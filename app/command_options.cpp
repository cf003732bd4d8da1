#include "app/command_options.h"

#include <cmath>

#include "app/command_examples.h"
#include "app/command_help.h"
#include "io/files/build_info.h"
#include "io/files/sandbox.h"
#include "io/files/shipped_files.h"
#include "io/json/manifest.h"
#include "io/json/named_file.h"

namespace sturm {

namespace {

std::string version_text() {
  const BuildInfo& b = build_info();
  return "sturm " + std::string(b.version) + " (commit " + std::string(b.commit) + ")\nbuilt with " +
         std::string(b.compiler) + ", " + std::string(b.build_type) + ", flags " + std::string(b.flags) +
         "\ninstruction set " + instruction_set() + "\n";
}

}  // namespace

std::string file_of_name(const std::string& kind, const std::string& name) {
  std::error_code code;
  if (std::filesystem::exists(name, code)) return name;
  auto shipped = kind.empty() ? std::nullopt : shipped_document(kind, name);
  if (!shipped && name.starts_with("configs/")) shipped = shipped_counterpart(name);
  return shipped ? shipped->string() : name;
}

void take_shipped_names(CLI::Option& option, const std::string& kind) {
  if (kind.empty()) return take_shipped_paths(option);
  option.transform([kind](const std::string& name) { return file_of_name(kind, name); }, "", shipped_validator(kind));
}

void take_shipped_paths(CLI::Option& option) {
  option.transform([](const std::string& name) { return file_of_name("", name); }, "", "");
}

void know_shipped_names(CLI::Option& option, const std::string& kind) {
  option.check([](const std::string&) { return std::string(); }, "", shipped_validator(kind));
}

void add_changes(CLI::App& command, CommonOptions& options, const char* schema) {
  command.preparse_callback([&options, schema](std::size_t) { options.schema = schema; });
  command.add_option("--set", options.assignments, "change the configuration: /json/pointer=value; may be repeated")
      ->allow_extra_args(false);
  command.add_flag("--print-config", options.print_config,
                   "print the document that the command line stands for, and do nothing else");
}

namespace {

std::string described(const char* what, const std::string& kind, const char* named) {
  return std::string(what) + (kind.empty() ? "" : named) + " (- is standard input)";
}

}  // namespace

CLI::Option* add_document(CLI::App& command, CommonOptions& options, const char* what, const char* schema) {
  const std::string kind = shipped_kind(schema);
  auto* file = command.add_option("file", options.file, described(what, kind, ", or the name of a shipped one"));
  take_shipped_names(*file->required(), kind);
  add_changes(command, options, schema);
  return file;
}

CLI::Option* add_documents(CLI::App& command, CommonOptions& options, const char* what, const char* schema) {
  const std::string kind = shipped_kind(schema);
  auto* files = command.add_option("files", options.files, described(what, kind, ", or names of shipped ones"));
  take_shipped_names(*files, kind);
  add_changes(command, options, schema);
  return files;
}

void add_prescription(CLI::App& command, CommonOptions& options, const char* whose) {
  command.add_option("--rx", options.prescription,
                     std::string("prescription of ") + whose + ", in place of the document's: \"-2.00 -1.50 x 30\"");
  command
      .add_option("--vertex", options.worn.vertex_mm,
                  "distance from the lens that it is written for to the cornea [mm]")
      ->check(CLI::Range(0.0, 50.0));
}

void add_wearer(CLI::App& command, CommonOptions& options) {
  add_prescription(command, options, "the eye");
  WearerOptions& w = options.worn;
  know_shipped_names(*command.add_option("--eye", w.eye, "the eye: a file (sturm.eye/1), or the name of a shipped one"),
                     "eyes");
  command.add_option("--pupil", w.pupil_mm, "diameter of the pupil [mm]")->check(CLI::Range(0.0, 100.0));
  auto* age = command.add_option("--age", w.age_years, "the eye accommodates as well as it can at this age [years]");
  age->check(CLI::Range(0.0, 150.0));
  auto* amplitude = command.add_option("--amplitude", w.amplitude_D, "or by at most so much [D]");
  amplitude->check(CLI::Range(0.0, 100.0))->excludes(age);
  command.add_option("--focus", w.focus_m, "or is set for one distance [m]; inf = relaxed")
      ->excludes(age)
      ->excludes(amplitude);
}

void add_spectacles(CLI::App& command, CommonOptions& options) {
  auto* lens = command.add_option("--lens", options.worn.lens, "spectacles: a file, or the name of a shipped lens");
  know_shipped_names(*lens, "lenses");
}

void add_answer_kinds(CLI::App& command, AnswerOptions& answer, const char* what) {
  auto* table =
      command.add_flag("--table", answer.table, std::string("a table (default without ") + what + ", and for several)");
  auto* csv = command.add_flag("--csv", answer.csv, "a table for programs")->excludes(table);
  command.add_flag("--json", answer.json, std::string("all numbers as JSON (default with ") + what + ")")
      ->excludes(table)
      ->excludes(csv);
}

void add_run_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--seed", options.seed, "seed of all random numbers");
  add_work_options(command, options);
}

void add_threads(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "threads to use; 0 = one per processor")->check(CLI::Range(0, 1024));
}

void add_work_options(CLI::App& command, CommonOptions& options) {
  add_threads(command, options);
  command.add_flag("--quiet", options.quiet, "no progress on stderr");
}

CLI::Option* add_common_options(CLI::App& command, CommonOptions& options, const char* what, const char* schema) {
  auto* file = add_document(command, options, what, schema);
  add_run_options(command, options);
  return file;
}

namespace {

/// Ranges let NaN pass, which is neither too small nor too large.
void refuse_nan(CLI::App& command) {
  for (CLI::Option* option : command.get_options())
    if (option->get_type_name().starts_with("FLOAT"))
      option->check(
          [](const std::string& value) {
            double number = 0.0;
            return CLI::detail::lexical_cast(value, number) && std::isnan(number) ? "got nan, expected a number"
                                                                                  : std::string();
          },
          "", "number");
}

}  // namespace

CommandLine::CommandLine() {
  app.require_subcommand(1);
  app.footer(
      "First steps:\n"
      "  sturm ellipse --rx \"-3.25 -1.75 x 160\" --pupil 5 --distance 0.4,1,6,inf\n"
      "  sturm render cornell --rx \"-3.25 -1.75 x 160\" --pupil 5 -o seen.png\n"
      "  sturm init view\n"
      "  sturm doctor\n"
      "sturm COMMAND --help explains a command.");
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
  add_serve();
  add_view();
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
  add_init();
  add_doctor();
  add_completion();
  add_man();
  for (CLI::App* command : app.get_subcommands({})) {
    command->fallthrough();
    command->footer(command_examples(command->get_name()));
    refuse_nan(*command);
  }
}

void CommandLine::add_validate() {
  auto* validate = app.add_subcommand("validate", "check a configuration without running it");
  auto* documents = validate->add_option("file", files, "documents of Sturm of any kind (- is standard input)");
  take_shipped_paths(*documents->required());
  validate->callback([this] { action = [this] { return validate_command(files); }; });
}

void CommandLine::add_schema() {
  auto* schema_app = app.add_subcommand("schema", "print a JSON schema, or the names of all");
  schema_app->add_option("name", schema, "e.g. experiment");
  schema_app->callback([this] { action = [this] { return schema_command(schema); }; });
}

}  // namespace sturm
