#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "experiments/run/replicates.h"
#include "io/specs/experiment/experiment_spec.h"

namespace sturm {

/// Path-traced pictures that several entries of an experiment ask for, the same bit by bit: the same scene, camera,
/// eye, samples and seed, and ray models with the same rays (power_matrix and thin_lens without a cylinder). Each is
/// rendered for the first that asks, and kept until the last has asked. All pictures of an experiment that are measured
/// by metrics share its seed; others have no part in this.
class SharedViews {
 public:
  struct View {
    Replicates replicates;
    double seconds;        ///< that it took when it was made
    std::string made_for;  ///< IMAGE/RAY_MODEL
  };

  /// `scenes`: of the experiment's pictures, in their order.
  SharedViews(const ExperimentSpec& spec, const std::vector<SceneDescription>& scenes);

  /// The view of picture number `index` by `model`, made by `make` unless it is there.
  std::shared_ptr<const View> get(std::size_t index, RayModel model, const std::function<View()>& make);

 private:
  struct Shared {
    int requests = 0;  ///< still to come
    std::shared_ptr<const View> view;
  };
  std::string key(std::size_t index, RayModel model) const;

  const ExperimentSpec& spec_;
  std::vector<std::string> fingerprints_;
  std::map<std::string, Shared> views_;
};

}  // namespace sturm
