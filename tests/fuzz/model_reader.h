#pragma once
#include "pathtrace/scene/scene_import.h"
#include "tests/fuzz/reader_under_test.h"

namespace sturm::fuzz {

/// Reads a scene of one model with these bytes in its file. Bytes of an MTL stand beside a triangle that uses them.
inline void read_model(const std::string& suffix, std::string_view bytes) {
  std::filesystem::path file = written("fuzzed." + suffix, bytes);
  if (suffix == "mtl")
    file = written("fuzzed.obj", "mtllib fuzzed.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
  SceneSpec scene;
  scene.models.push_back({.file = file});
  try_reader([&] { build_scene(scene); });
}

}  // namespace sturm::fuzz
