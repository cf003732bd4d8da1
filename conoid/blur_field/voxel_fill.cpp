#include "conoid/blur_field/voxel_fill.h"

#include <cmath>

#include "conoid/blur_field/rows.h"
#include "conoid/threads/parallel_for.h"
#include "conoid/tracing/previous.h"
#include "conoid/tracing/published.h"
#include "lensmodel/best_accommodation.h"

namespace sturm {

namespace {

/// X/d of one direction, affine in the vergence 1/d [rad/m].
struct AffineFootprint {
  Eigen::Matrix2d constant, slope;
  Eigen::Matrix2d at(double vergence_D) const { return constant + vergence_D * slope; }
};

AffineFootprint affine(const SpectacleConoid& conoid, const Eigen::Matrix2d& slopes) {
  return {conoid.exit.slopes(slopes), conoid.exit.offsets(slopes)};
}

/// angular_map at the vergences 0 and 1, between which it is a straight line.
AffineFootprint affine(const PublishedConoid& published, const RayTransfer& frame) {
  const Eigen::Matrix2d constant = angular_map(published, frame.e1, frame.e2, 0.0);
  return {constant, angular_map(published, frame.e1, frame.e2, 1.0) - constant};
}

/// The inner loop of a blur field: out[4k + c] = constant[c] + vergence[k]·slope[c], with each vergence repeated four
/// times so that the compiler sees whole vectors.
void fill_line(const float* constant, const float* slope, const std::vector<float>& repeated_vergences, float* out) {
  constexpr std::size_t lanes = 16;
  float constants[lanes], slopes[lanes];
  for (std::size_t m = 0; m < lanes; ++m) {
    constants[m] = constant[m % 4];
    slopes[m] = slope[m % 4];
  }
  const float* vergence = repeated_vergences.data();
  const std::size_t n = repeated_vergences.size(), whole = n - n % lanes;
  for (std::size_t first = 0; first < whole; first += lanes)
    for (std::size_t m = 0; m < lanes; ++m) out[first + m] = constants[m] + vergence[first + m] * slopes[m];
  for (std::size_t m = whole; m < n; ++m) out[m] = constants[m - whole] + vergence[m] * slopes[m - whole];
}

/// What is the same for all directions.
struct Job {
  const Spectacles* lens;
  const Eye& eye;
  const FieldGrid& grid;
  FieldMethod method;
  std::vector<float> repeated_vergences;  ///< of the slices, four of each
  const BestAccommodation* best;
  double fixed_D;                ///< accommodation of the other modes
  Eigen::Matrix2d fixed_slopes;  ///< and their S = F − A·I
};

/// One direction's voxels.
class ColumnFill {
 public:
  ColumnFill(const Job& job, VoxelField& field, int i, int j)
      : job_(job), field_(field), i_(i), j_(j), direction_(job.grid.index(i, j)) {}

  void operator()(const SpectacleConoid& conoid) {
    if (conoid.status != LensStatus::ok) {
      each([](int) { return std::nullopt; });
    } else if (job_.method == FieldMethod::ray_transfer) {
      by_ray_transfer(conoid);
    } else if (job_.method == FieldMethod::published) {
      by_published(conoid);
    } else {
      by_previous(conoid);
    }
  }

 private:
  template <class Footprint>
  void each(Footprint&& footprint_at) {
    for (int k = 0; k < job_.grid.nz; ++k) {
      if (!field_.stores(direction_, k)) continue;
      const std::optional<Eigen::Matrix2d> footprint = footprint_at(k);
      if (footprint)
        store_rows(*footprint, field_.voxel(direction_, k));
      else
        field_.set_undefined(direction_, k);
    }
  }

  /// In single precision: where both terms cancel, near a focus, the error is that of the terms, 1e-7 of the footprint
  /// without that focus.
  void straight(const AffineFootprint& line) {
    float constant[4], slope[4];
    store_rows(line.constant, constant);
    store_rows(line.slope, slope);
    if (field_.sparse()) {
      for (int k = 0; k < job_.grid.nz; ++k) {
        if (!field_.stores(direction_, k)) continue;
        float* voxel = field_.voxel(direction_, k);
        for (int c = 0; c < 4; ++c)
          voxel[c] = constant[c] + job_.repeated_vergences[4 * static_cast<std::size_t>(k)] * slope[c];
      }
      return;
    }
    fill_line(constant, slope, job_.repeated_vergences, field_.column(direction_));
  }

  Eigen::Vector3d line_of_sight() const { return job_.grid.line_of_sight(job_.grid.ndc_x(i_), job_.grid.ndc_y(j_)); }

  double best_at(const SpectacleConoid& conoid, double vergence) const {
    return best_accommodation(conoid.angular_footprint(job_.eye.correction.matrix(), vergence),
                              conoid.angular_q(vergence), job_.best->amplitude_D);
  }

  void by_ray_transfer(const SpectacleConoid& conoid) {
    if (!job_.best) return straight(affine(conoid, job_.fixed_slopes));
    each([&](int k) {
      const double vergence = job_.grid.vergence(k);
      return std::optional(
          conoid.angular_footprint(job_.eye.slope_matrix(best_at(conoid, vergence)).matrix(), vergence));
    });
  }

  void by_published(const SpectacleConoid& conoid) {
    const Eigen::Vector3d gaze = line_of_sight();
    const auto traced = [&](double accommodation_D) -> std::optional<AffineFootprint> {
      const auto published = trace_published(job_.eye, accommodation_D, job_.lens, gaze);
      return published ? std::optional(affine(*published, conoid.exit)) : std::nullopt;
    };
    const auto relaxed = traced(job_.best ? 0.0 : job_.fixed_D);
    if (!relaxed) return each([](int) { return std::nullopt; });
    if (!job_.best) return straight(*relaxed);
    const auto tense = traced(job_.best->amplitude_D);
    each([&](int k) -> std::optional<Eigen::Matrix2d> {
      if (!tense) return std::nullopt;
      const double vergence = job_.grid.vergence(k);
      return mixed(relaxed->at(vergence), tense->at(vergence)).map;
    });
  }

  void by_previous(const SpectacleConoid& conoid) {
    const PreviousMethod previous(job_.lens, line_of_sight(), job_.eye.rotation_center_m);
    each([&](int k) {
      const double vergence = job_.grid.vergence(k),
                   accommodation = job_.best ? best_at(conoid, vergence) : job_.fixed_D;
      const auto blur = previous.blur(job_.eye.slope_matrix(accommodation).matrix(), vergence);
      return blur ? std::optional(blur->angular()) : std::nullopt;
    });
  }

  const Job& job_;
  VoxelField& field_;
  int i_, j_;
  std::size_t direction_;
};

}  // namespace

VoxelField fill_voxels(const Spectacles* lens, const Eye& eye, const FieldGrid& grid,
                       const TracedDirections& directions, FieldMethod method, const VoxelMask* visible) {
  VoxelField field = visible ? VoxelField(*visible) : VoxelField(grid);
  Job job{lens, eye, grid, method, {}, std::get_if<BestAccommodation>(&eye.accommodation), 0.0, {}};
  if (!job.best) job.fixed_D = eye.accommodation_for(0.0);
  job.fixed_slopes = eye.slope_matrix(job.fixed_D).matrix();
  for (int k = 0; k < grid.nz; ++k)
    job.repeated_vergences.insert(job.repeated_vergences.end(), 4, static_cast<float>(grid.vergence(k)));
  if (method != FieldMethod::ray_transfer || directions.counters.usable < grid.directions()) field.prepare_undefined();
  parallel_for(0, grid.ny, [&](int j) {
    for (int i = 0; i < grid.nx; ++i) ColumnFill(job, field, i, j)(directions.conoids[grid.index(i, j)]);
  });
  return field;
}

}  // namespace sturm
