#pragma once
#include <filesystem>

namespace sturm {

/// Throws RuntimeFailure where ffmpeg cannot be run.
void require_ffmpeg();

/// Joins the frames STEM_0001.png, STEM_0002.png, … of a folder into the film STEM.mp4 beside them, 25 in a second
/// (H.264 or what else ffmpeg takes for that name). The file appears complete or not at all. Throws RuntimeFailure.
std::filesystem::path join_frames(const std::filesystem::path& stem);

}  // namespace sturm
