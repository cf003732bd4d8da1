#pragma once
#include <Eigen/Core>
#include <optional>

#include "conoid/tracing/interface.h"
#include "lensmodel/sag.h"

namespace sturm {

/// A wavefront to second order about a chief ray: direction, a frame across it and the curvature matrix K on that frame
/// [1/m], positive where the centre of curvature lies ahead (docs/theory.md#112-a-wavefront-along-the-chief-ray).
struct Wavefront {
  Eigen::Vector3d direction;
  Eigen::Vector3d e1, e2;
  Eigen::Matrix2d curvature;

  /// The same wave on another frame across its direction.
  Wavefront on(const Eigen::Vector3d& f1, const Eigen::Vector3d& f2) const;
};

/// Further along by d: K (I − dK)⁻¹. None where the wave has a focus there (I − dK singular). [Kakimoto2010] eq. 1
std::optional<Wavefront> transferred(const Wavefront& wave, double distance);

/// Behind a surface whose frames and directions are `at`: C'K'C' = μ C K C + γ K_s; also a reflection. The result
/// stands on (u, v_out). [Kakimoto2010] eqs. 2–6 in matrix form
Wavefront through(const Wavefront& wave, const Interface& at, const SurfaceElement& surface);

/// The same with the surface's curvature given on (u, n × u) [1/m], positive where its centre lies ahead of the wave.
Wavefront through(const Wavefront& wave, const Interface& at, const Eigen::Matrix2d& surface_curvature);

/// Behind a thin lens (or the eye) across the chief ray: n₂K' = n₁K + P, P on (e1, e2) [D]. [Kakimoto2010] eqs. 7–8
Wavefront through_thin_lens(const Wavefront& wave, const Eigen::Matrix2d& power, double index_before = 1.0,
                            double index_behind = 1.0);

}  // namespace sturm
