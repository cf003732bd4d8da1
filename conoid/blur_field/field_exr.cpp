#include "conoid/blur_field/field_exr.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "io/files/error.h"
#include "io/images/exr_parts.h"

namespace sturm {

namespace {

constexpr const char* grid_key = "sturm.grid";

/// Seven numbers, each so that it reads back exactly.
std::string text_of(const FieldGrid& g) {
  std::string text;
  for (const double number : {static_cast<double>(g.nx), static_cast<double>(g.ny), static_cast<double>(g.nz),
                              g.tan_half_width, g.tan_half_height, g.near_vergence_D, g.far_vergence_D}) {
    char buffer[32];
    text += (text.empty() ? "" : " ") + std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
  }
  return text;
}

FieldGrid grid_of(const std::string& text) {
  std::array<double, 7> n{};
  const char *at = text.data(), *end = at + text.size();
  for (double& number : n) {
    while (at != end && *at == ' ') ++at;
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc()) throw std::runtime_error("a grid of " + std::to_string(n.size()) + " numbers is missing");
    at = stop;
  }
  for (const double size : {n[0], n[1], n[2]})
    if (!(size >= 2.0 && size <= 4096.0)) throw std::runtime_error("a grid without a size");
  return {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]), n[3], n[4], n[5], n[6]};
}

ExrPart chief_ray_part(const FieldGrid& grid, const TracedDirections& directions,
                       const std::map<std::string, std::string>& metadata) {
  ExrPart part{"chief_rays",
               {"status", "origin.X", "origin.Y", "origin.Z", "direction.X", "direction.Y", "direction.Z"},
               Image(grid.nx, grid.ny, 7),
               metadata};
  part.metadata[grid_key] = text_of(grid);
  for (std::size_t d = 0; d < grid.directions(); ++d) {
    const SpectacleConoid& conoid = directions.conoids[d];
    float* pixel = &part.image.pixels[7 * d];
    pixel[0] = static_cast<float>(conoid.status);
    if (conoid.status != LensStatus::ok) continue;
    for (int c = 0; c < 3; ++c) {
      pixel[1 + c] = static_cast<float>(conoid.chief_ray.origin[c]);
      pixel[4 + c] = static_cast<float>(conoid.chief_ray.direction[c]);
    }
  }
  return part;
}

ExrPart analytic_part(const DepthAnalyticField& field) {
  ExrPart part{"depth_analytic", {}, Image(field.grid().nx, field.grid().ny, 16), {}};
  for (const char* matrix : {"A", "B", "Q0", "Q1"})
    for (const char* entry : {".xx", ".xy", ".yx", ".yy"}) part.channels.push_back(std::string(matrix) + entry);
  for (std::size_t d = 0; d < field.nodes().size(); ++d) {
    const DepthAnalyticField::Node& node = field.nodes()[d];
    float* pixel = &part.image.pixels[16 * d];
    for (const float* matrix : {node.a, node.b, node.q0, node.q1}) pixel = std::copy_n(matrix, 4, pixel);
  }
  return part;
}

constexpr float left_out = -1.0f, undefined = 0.0f, with_footprint = 1.0f;  ///< states of a voxel

ExrPart voxel_part(const VoxelField& field) {
  const FieldGrid& grid = field.grid();
  ExrPart part{"voxels", {"xx", "xy", "yx", "yy", "state"}, Image(grid.nx, grid.ny * grid.nz, 5), {}};
  for (std::size_t d = 0; d < grid.directions(); ++d)
    for (int k = 0; k < grid.nz; ++k) {
      float* pixel = &part.image.pixels[5 * (static_cast<std::size_t>(k) * grid.directions() + d)];
      if (!field.stores(d, k)) {
        pixel[4] = left_out;
        continue;
      }
      std::copy_n(field.voxel(d, k), 4, pixel);
      pixel[4] = field.defined(d, k) ? with_footprint : undefined;
    }
  return part;
}

/// The pixels of a part on the channels asked for, in that order.
std::vector<float> channels_of(const ExrPart& part, const std::vector<std::string>& names) {
  std::vector<std::size_t> from;
  for (const std::string& name : names) {
    const auto at = std::find(part.channels.begin(), part.channels.end(), name);
    if (at == part.channels.end()) throw std::runtime_error("the channel " + name + " of " + part.name + " is missing");
    from.push_back(static_cast<std::size_t>(at - part.channels.begin()));
  }
  const auto stride = static_cast<std::size_t>(part.image.channels);
  std::vector<float> values;
  values.reserve(part.image.pixels.size() / stride * names.size());
  for (std::size_t pixel = 0; pixel < part.image.pixels.size(); pixel += stride)
    for (const std::size_t c : from) values.push_back(part.image.pixels[pixel + c]);
  return values;
}

void require_size(const ExrPart& part, int width, int height) {
  if (part.image.width != width || part.image.height != height)
    throw std::runtime_error("the part " + part.name + " does not fit the grid");
}

std::vector<FieldChiefRay> chief_rays_of(const ExrPart& part, const FieldGrid& grid) {
  require_size(part, grid.nx, grid.ny);
  const std::vector<float> v =
      channels_of(part, {"status", "origin.X", "origin.Y", "origin.Z", "direction.X", "direction.Y", "direction.Z"});
  std::vector<FieldChiefRay> rays;
  for (std::size_t i = 0; i < v.size(); i += 7) {
    if (!(v[i] >= 0.0f && v[i] <= 3.0f)) throw std::runtime_error("an unknown status");
    rays.push_back({static_cast<LensStatus>(static_cast<int>(v[i])),
                    {{v[i + 1], v[i + 2], v[i + 3]}, {v[i + 4], v[i + 5], v[i + 6]}}});
  }
  return rays;
}

DepthAnalyticField analytic_of(const ExrPart& part, const FieldGrid& grid, const std::vector<FieldChiefRay>& rays) {
  require_size(part, grid.nx, grid.ny);
  const std::vector<float> v =
      channels_of(part, {"A.xx", "A.xy", "A.yx", "A.yy", "B.xx", "B.xy", "B.yx", "B.yy", "Q0.xx", "Q0.xy", "Q0.yx",
                         "Q0.yy", "Q1.xx", "Q1.xy", "Q1.yx", "Q1.yy"});
  std::vector<DepthAnalyticField::Node> nodes(grid.directions());
  std::vector<std::uint8_t> usable;
  const float* from = v.data();
  for (std::size_t d = 0; d < nodes.size(); ++d) {
    for (float* matrix : {nodes[d].a, nodes[d].b, nodes[d].q0, nodes[d].q1}) {
      std::copy_n(from, 4, matrix);
      from += 4;
    }
    usable.push_back(rays[d].status == LensStatus::ok);
  }
  return {grid, std::move(nodes), std::move(usable)};
}

VoxelField voxels_of(const ExrPart& part, const FieldGrid& grid) {
  require_size(part, grid.nx, grid.ny * grid.nz);
  const std::vector<float> v = channels_of(part, {"xx", "xy", "yx", "yy", "state"});
  const auto pixel = [&](std::size_t direction, int k) {
    return &v[5 * (static_cast<std::size_t>(k) * grid.directions() + direction)];
  };
  VoxelMask stored(grid);
  for (std::size_t d = 0; d < grid.directions(); ++d)
    for (int k = 0; k < grid.nz; ++k)
      if (pixel(d, k)[4] != left_out) stored.set(d, k);
  VoxelField field = stored.count() == grid.voxels() ? VoxelField(grid) : VoxelField(stored);
  field.prepare_undefined();
  for (std::size_t d = 0; d < grid.directions(); ++d)
    for (int k = 0; k < grid.nz; ++k) {
      if (!field.stores(d, k)) continue;
      if (pixel(d, k)[4] == with_footprint)
        std::copy_n(pixel(d, k), 4, field.voxel(d, k));
      else
        field.set_undefined(d, k);
    }
  return field;
}

}  // namespace

void write_blur_field(const std::filesystem::path& path, const FieldGrid& grid, const TracedDirections& directions,
                      const DepthAnalyticField* analytic, const VoxelField* voxels,
                      const std::map<std::string, std::string>& metadata) {
  std::vector<ExrPart> parts{chief_ray_part(grid, directions, metadata)};
  if (analytic) parts.push_back(analytic_part(*analytic));
  if (voxels) parts.push_back(voxel_part(*voxels));
  write_exr_parts(path, parts);
}

StoredBlurField read_blur_field(const std::filesystem::path& path) {
  const std::vector<ExrPart> parts = read_exr_parts(path);
  const auto part = [&](const char* name) -> const ExrPart* {
    for (const ExrPart& p : parts)
      if (p.name == name) return &p;
    return nullptr;
  };
  try {
    const ExrPart* rays = part("chief_rays");
    if (!rays || !rays->metadata.contains(grid_key)) throw std::runtime_error("no part chief_rays with a grid");
    StoredBlurField field;
    field.grid = grid_of(rays->metadata.at(grid_key));
    field.metadata = rays->metadata;
    field.metadata.erase(grid_key);
    field.chief_rays = chief_rays_of(*rays, field.grid);
    if (const ExrPart* p = part("depth_analytic")) field.analytic = analytic_of(*p, field.grid, field.chief_rays);
    if (const ExrPart* p = part("voxels")) field.voxels = voxels_of(*p, field.grid);
    return field;
  } catch (const std::runtime_error& error) {
    throw InputError(path.string(), "", error.what(), "a blur field that this program wrote");
  }
}

}  // namespace sturm
