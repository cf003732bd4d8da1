#include "conoid/pictures/surface_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "conoid/pictures/lamp_reach.h"

namespace sturm {
namespace {

class Pieces {
 public:
  Pieces(const FragmentImage& view, int oversampling, const SightField& field)
      : view_(view), n_(oversampling), field_(field), sheet_D_(sheet_thickness_D(oversampling, field)) {}

  std::vector<SurfacePiece> collect(const std::vector<UnseenPiece>& unseen) {
    for (int y = 0; y < view_.height; ++y)
      for (int x = 0; x < view_.width; ++x) add_fragments(x, y);
    for (std::size_t i = 0; i < unseen.size();) {
      const std::size_t first = pieces_.size();
      const auto x = static_cast<std::int32_t>(std::floor(unseen[i].place.x() * n_)),
                 y = static_cast<std::int32_t>(std::floor(unseen[i].place.y() * n_));
      std::size_t end = i;
      for (; end < unseen.size() && unseen[end].place == unseen[i].place; ++end)
        pieces_.push_back({x, y, unseen[end].vergence_D, unseen[end].share, unseen[end].radiance});
      complete_sheets(first, true);
      i = end;
    }
    return std::move(pieces_);
  }

 private:
  void add_fragments(int x, int y) {
    const auto fragments = view_.at(x, y);
    if (fragments.empty()) return;
    const auto chief = field_.chief_ray({(x + 0.5) / n_, (y + 0.5) / n_});
    const std::size_t first = pieces_.size();
    const bool rim =
        at_lamp_rim(view_, x, y, 2);  // the lamp, what it shines into, and what that gives light to in turn
    for (const Fragment& f : fragments)
      pieces_.push_back({x, y, vergence_of(f, chief), f.share, f.radiance, rim ? &f : nullptr});
    complete_sheets(first);
  }

  static double vergence_of(const Fragment& f, const std::optional<LightRay>& chief) {
    if (f.surroundings || !chief) return 0.0;
    const double t = (f.position.cast<double>() - chief->origin).dot(chief->direction) / chief->direction.squaredNorm();
    return t > 0.0 ? 1.0 / t : 0.0;
  }

  /// The pieces of one pixel from `first` on: those of about the same depth are one sheet, and a sheet goes on behind
  /// what is nearer. `unknown_shares`: nothing is known of the pieces but that they are there, except for lamps.
  void complete_sheets(std::size_t first, bool unknown_shares = false) {
    const auto begin = pieces_.begin() + static_cast<std::ptrdiff_t>(first);
    std::stable_sort(begin, pieces_.end(),
                     [](const SurfacePiece& a, const SurfacePiece& b) { return a.vergence_D > b.vergence_D; });
    float nearer = 0.0f;
    for (auto sheet = begin; sheet != pieces_.end();) {
      auto end = sheet;
      float own = 0.0f;
      for (; end != pieces_.end() && sheet->vergence_D - end->vergence_D <= sheet_D_; ++end) own += end->coverage;
      const float scale = unknown_shares ? 1.0f / std::max(own, 1.0f) : (nearer + own) / own;
      for (auto s = sheet; s != end; ++s) s->coverage *= scale;
      nearer += own;
      sheet = end;
    }
  }

  const FragmentImage& view_;
  int n_;
  const SightField& field_;
  double sheet_D_;
  std::vector<SurfacePiece> pieces_;
};

}  // namespace

double sheet_thickness_D(int oversampling, const SightField& field) {
  const double px_per_dioptre = field.eye().pupil_radius_m / field.plane().pixel_slope;
  return px_per_dioptre > 0.0 ? 1.0 / (oversampling * px_per_dioptre) : std::numeric_limits<double>::infinity();
}

std::vector<SurfacePiece> surface_pieces(const FragmentImage& view, int oversampling, const SightField& field,
                                         const std::vector<UnseenPiece>& unseen) {
  return Pieces(view, oversampling, field).collect(unseen);
}

}  // namespace sturm
