#include "reports/plots/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <regex>

#include "io/files/error.h"
#include "reports/markup/escaped.h"

extern char** environ;

namespace sturm {

namespace {

using File = std::unique_ptr<FILE, int (*)(FILE*)>;

/// A nameless temporary file. Files instead of pipes: neither side can block the other, and a dead child raises no
/// SIGPIPE.
File scratch_file() {
  File file(std::tmpfile(), &std::fclose);
  if (!file) throw RuntimeFailure(std::string("cannot create a temporary file for gnuplot: ") + std::strerror(errno));
  fcntl(fileno(file.get()), F_SETFD, FD_CLOEXEC);
  return file;
}

std::string contents(FILE* file) {
  std::string text;
  std::array<char, 65536> block;
  std::rewind(file);
  for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), file)) > 0;) text.append(block.data(), n);
  return text;
}

std::string run_gnuplot(std::string_view script) {
  const File input = scratch_file(), output = scratch_file(), complaints = scratch_file();
  if (std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() || std::fflush(input.get()) != 0) {
    throw RuntimeFailure(std::string("cannot write the script for gnuplot: ") + std::strerror(errno));
  }
  std::rewind(input.get());

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(output.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(complaints.get()), STDERR_FILENO);
  char name[] = "gnuplot",
       defaults[] = "--default-settings";  // the user's own start-up file must not restyle the report
  char* arguments[] = {name, defaults, nullptr};
  pid_t child = 0;
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t fatal;  // what this program ignores ends gnuplot, which does not look whether it could write
  sigemptyset(&fatal);
  sigaddset(&fatal, SIGPIPE);
  sigaddset(&fatal, SIGXFSZ);
  posix_spawnattr_setsigdefault(&attributes, &fatal);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  const int failed = posix_spawnp(&child, name, &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    throw RuntimeFailure(
        std::string("the report's plots need gnuplot, which cannot be started (Debian package gnuplot-nox): ") +
        std::strerror(failed));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw RuntimeFailure(std::string("lost the gnuplot process: ") + std::strerror(errno));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw RuntimeFailure("gnuplot could not draw a plot of the report: " + contents(complaints.get()));
  }
  return contents(output.get());
}

/// gnuplot does not tell of a temporary folder that is full.
std::string whole_picture(std::string picture, std::string_view end) {
  if (picture.find(end, picture.size() - std::min(picture.size(), 2 * end.size() + 8)) == std::string::npos)
    throw RuntimeFailure("gnuplot wrote no whole picture");
  return picture;
}

/// The picture's own element, without what only a free-standing SVG file needs.
Html for_inline_use(std::string svg, const PlotFrame& frame) {
  const std::size_t start = svg.find("<svg");
  const std::size_t end = svg.rfind("</svg>");
  if (start == std::string::npos || end == std::string::npos) throw RuntimeFailure("gnuplot wrote no SVG picture");
  svg = svg.substr(start, end + 6 - start);
  svg = std::regex_replace(svg, std::regex(R"re(\sxmlns(:xlink)?="[^"]*")re"), "");
  svg = std::regex_replace(svg, std::regex(R"re(\sfont-family="[^"]*")re"), "");
  svg = std::regex_replace(svg, std::regex("xlink:href="), "href=");
  // gnuplot gives each curve an id, some of them twice; nothing refers to those. Several plots share the page, so the
  // ids that are needed must not meet.
  svg = std::regex_replace(svg, std::regex(R"re(\sid="gnuplot_[^"]*")re"), "");
  svg = std::regex_replace(svg, std::regex(R"re((\sid=['"]|href=['"]#))re"), "$1" + frame.id + "-");
  svg = std::regex_replace(svg, std::regex(R"re(url\(#)re"), "url(#" + frame.id + "-");
  svg = std::regex_replace(svg, std::regex("<title>gnuplot_plot_[^<]*</title>"), "");
  svg = std::regex_replace(svg, std::regex("<title>Gnuplot</title>\\s*<desc>[^<]*</desc>"), "");
  svg.insert(4, " class=\"plot\" role=\"img\" aria-label=\"" + escaped(frame.label) + "\"");
  return Html::trusted(svg + "\n");
}

}  // namespace

std::string gnuplot_file(std::string_view script, const PlotFrame& frame) {
  const std::string setup = "set encoding utf8\nset terminal svg size " + std::to_string(frame.width) + "," +
                            std::to_string(frame.height) + " dynamic enhanced font \"sans-serif,13\"\n";
  return whole_picture(run_gnuplot(setup + std::string(script) + "\n"), "</svg>");
}

Html gnuplot_svg(std::string_view script, const PlotFrame& frame) {
  return for_inline_use(gnuplot_file(script, frame), frame);
}

std::string gnuplot_labelled_file(std::string_view script, const PlotFrame& frame) {
  std::string svg = gnuplot_svg(script, frame).markup();
  svg.insert(
      4,
      " xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" font-family=\"sans-serif\"");
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n" + svg;
}

std::string gnuplot_png(std::string_view script, const PlotFrame& frame) {
  const std::string setup = "set encoding utf8\nset terminal pngcairo size " + std::to_string(2 * frame.width) + "," +
                            std::to_string(2 * frame.height) +
                            " enhanced font \"sans-serif,13\" fontscale 1.5 linewidth 2 pointscale 2\n";
  return whole_picture(run_gnuplot(setup + std::string(script) + "\n"), "IEND");
}

std::string gnuplot_pdf(std::string_view script, const PlotFrame& frame) {
  constexpr double pixels_per_inch = 96.0;
  const std::string setup = "set encoding utf8\nset terminal pdfcairo size " +
                            std::to_string(frame.width / pixels_per_inch) + "in," +
                            std::to_string(frame.height / pixels_per_inch) + "in enhanced font \"sans-serif,9.75\"\n";
  return whole_picture(run_gnuplot(setup + std::string(script) + "\n"), "%%EOF");
}

}  // namespace sturm
