#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/experiment/gate_kind.h"

namespace sturm {

/// How much of the way from perfect agreement to the bound is left for what is no chance, in the gate's unit.
struct GateTolerance {
  double value = 0.0;  ///< ≥ 0
  std::string reason;
};

/// The noise that a bound was calibrated on: how far the statistic scatters between seeds when nothing else changes.
struct GateNoise {
  std::optional<double>
      standard_deviation;  ///< in the gate's unit; 0: the statistic does not depend on a seed; none: not measured
  std::string source;      ///< what was run to find it, or why there is none
};

/// What a gate's bound was calibrated on.
struct GateCalibration {
  std::optional<double> level;  ///< at most this is the chance that the gate fails in one run though nothing is wrong,
                                ///< 0 ≤ level < 1; none: not known
  GateTolerance tolerance;
  GateNoise noise;
};

/// One requirement on a named statistic of a report.
struct GateSpec {
  std::string id, title;
  std::string statistic;
  GateKind kind = GateKind::AtMost;
  double bound = 0.0;
  std::string unit;
  std::string reason;  ///< where the bound comes from

  std::optional<GateCalibration> calibration{};  ///< none: the gate states none
};

/// Validates and reads a document of format sturm.gates/1; ids are unique, a calibration is there as a whole or not at
/// all, and a statistic without noise has the level 0. Throws InputError.
std::vector<GateSpec> read_gates(const Json& document, const std::string& file);

/// Throws InputError unless every gate of `file` states its level, its tolerance and the noise that it was calibrated
/// on.
void require_calibrated(const std::vector<GateSpec>& gates, const std::string& file);

/// "level", "tolerance" and "noise" of a gate, as they stand in a gates file; empty for a gate without.
Json calibration_json(const std::optional<GateCalibration>& calibration);

/// Reads them back from a gate that follows the schema of gates or of reports; none unless all are there.
std::optional<GateCalibration> read_calibration(const Json& gate);

}  // namespace sturm
