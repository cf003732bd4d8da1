#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "app/commands.h"

namespace sturm {

/// The commands with their options; `action` is what the chosen one does.
struct CommandLine {
  CLI::App app{"Sturm: the blur of an astigmatic eye, path traced and predicted, and whether the two agree.", "sturm"};
  CommonOptions common;
  EllipseOptions ellipse;
  LensOptions lens;
  PlotOptions plot;
  ValidateCameraOptions validate_camera;
  WearersOptions wearers;
  BlurFieldOptions blurfield;
  PreviewOptions preview;
  SeeOptions see;
  ServeOptions serve;
  StressOptions stress;
  CompareOptions compare;
  CompareRunsOptions compare_runs;
  PlanOptions plan;
  GateOptions gate;
  PsfOptions psf;
  WavefrontOptions wavefront;
  InitOptions init;
  std::vector<std::string> files;
  std::string output, folder, schema, shell, page_template;
  bool resume = false, explain = false;
  std::function<int()> action;

  CommandLine();

 private:
  // command_options_of_optics.cpp
  void add_ellipse();
  void add_lens();
  void add_blurfield();
  void add_psf();
  void add_wavefront();
  void add_stress();
  void add_plan_samples();
  // command_options_of_plots.cpp
  void add_plot();
  void add_wearers();
  void add_validate_camera();
  // command_options_of_pictures.cpp
  void add_render();
  void add_serve();
  void add_view();
  void add_see();
  void add_see_depth(CLI::App& s);
  void add_see_view(CLI::App& s);
  void add_see_sequences(CLI::App& s);
  void add_compare();
  void add_compare_suite(CLI::App& c);
  // command_options_of_runs.cpp
  void add_run();
  void add_bench();
  void add_compare_runs();
  void add_gate();
  void add_report();
  void add_validate();
  void add_schema();
  // command_options_of_help.cpp
  void add_init();
  void add_doctor();
  void add_completion();
  void add_man();
};

// What several commands share.
/// The shipped document of a folder of configs/ that a plain name means, or the shipped file that a path
/// configs/FOLDER/NAME means where there is no file; anything else as it stands.
std::string file_of_name(const std::string& kind, const std::string& name);
/// A plain name given to the option means a shipped document of this folder, and completions offer these.
void take_shipped_names(CLI::Option& option, const std::string& kind);
/// A path configs/FOLDER/NAME given to the option means a shipped file where there is none.
void take_shipped_paths(CLI::Option& option);
/// Completions offer these names; the command itself knows what they mean.
void know_shipped_names(CLI::Option& option, const std::string& kind);
/// `schema` is the kind of document, whose shipped ones may be named. Returns the option of the file, which must be
/// given.
CLI::Option* add_document(CLI::App& command, CommonOptions& options, const char* what, const char* schema);
/// The same for commands that answer several documents, each by itself; none need be given.
CLI::Option* add_documents(CLI::App& command, CommonOptions& options, const char* what, const char* schema);
/// What changes a document on the command line: --set and --print-config.
void add_changes(CLI::App& command, CommonOptions& options, const char* schema);
void add_prescription(CLI::App& command, CommonOptions& options, const char* whose);
/// The eye, its prescription, vertex distance, pupil and accommodation.
void add_wearer(CLI::App& command, CommonOptions& options);
void add_spectacles(CLI::App& command, CommonOptions& options);
/// --table, --csv and --json of commands that answer a document (`what`: "a query") or a line.
void add_answer_kinds(CLI::App& command, AnswerOptions& answer, const char* what);
void add_threads(CLI::App& command, CommonOptions& options);
/// --threads and --quiet.
void add_work_options(CLI::App& command, CommonOptions& options);
/// The same, and --seed, for commands that draw at random.
void add_run_options(CLI::App& command, CommonOptions& options);
CLI::Option* add_common_options(CLI::App& command, CommonOptions& options, const char* what, const char* schema);

}  // namespace sturm
