#include "app/film.h"

#include <regex>
#include <string>

#include "io/files/child_program.h"

namespace sturm {

namespace {

void run_ffmpeg(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "ffmpeg");
  output_of({std::move(arguments),
             "--film needs ffmpeg, which cannot be started (Debian package ffmpeg; without --film the frames alone are "
             "written)",
             "ffmpeg could not make the film"});
}

}  // namespace

void require_ffmpeg() {
  run_ffmpeg({"-version"});
}

std::filesystem::path join_frames(const std::filesystem::path& stem) {
  const std::filesystem::path film = stem.string() + ".mp4", unfinished = stem.string() + ".unfinished.mp4";
  const std::string frames = std::regex_replace(stem.string(), std::regex("%"), "%%") + "_%04d.png";
  try {
    run_ffmpeg({"-loglevel", "error", "-y", "-framerate", "25", "-start_number", "1", "-i", frames, "-vf",
                "pad=ceil(iw/2)*2:ceil(ih/2)*2",  // colours are stored for blocks of four pixels
                "-pix_fmt", "yuv420p", unfinished.string()});
    std::filesystem::rename(unfinished, film);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw;
  }
  return film;
}

}  // namespace sturm
