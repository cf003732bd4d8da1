#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "conoid/blur_field/depth_analytic_field.h"
#include "conoid/blur_field/voxel_field.h"
#include "lensmodel/light_ray.h"

namespace sturm {

/// Where one line of sight goes: status, and the chief ray from the exit point (naked eye: from the pupil).
struct FieldChiefRay {
  LensStatus status;
  LightRay ray;  ///< all 0 unless ok
};

/// A blur field as it lies in a file. Single precision throughout.
struct StoredBlurField {
  FieldGrid grid;
  std::vector<FieldChiefRay> chief_rays;  ///< in the order of FieldGrid::index
  std::optional<DepthAnalyticField> analytic;
  std::optional<VoxelField> voxels;
  std::map<std::string, std::string> metadata;  ///< of the part chief_rays, without the grid
};

/// Parts of the file: `chief_rays` (nx × ny: status, origin.X … direction.Z), `depth_analytic` (nx × ny: A, B, Q0 and
/// Q1, each .xx .xy .yx .yy) and `voxels` (nx wide; the slices one below the other, nearest first: xx, xy, yx, yy and
/// state, which is 1 for a voxel with a footprint, 0 for one without and −1 for one that was left out). The grid stands
/// in the metadata of the first part. Throws RuntimeFailure if the file cannot be written.
void write_blur_field(const std::filesystem::path& path, const FieldGrid& grid, const TracedDirections& directions,
                      const DepthAnalyticField* analytic, const VoxelField* voxels,
                      const std::map<std::string, std::string>& metadata);

/// Reads a file of write_blur_field. Throws InputError for anything else.
StoredBlurField read_blur_field(const std::filesystem::path& path);

}  // namespace sturm
