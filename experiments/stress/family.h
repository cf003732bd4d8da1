#pragma once
#include <array>
#include <cstdint>

namespace sturm::stress {

/// Where a case comes from: ordinary life, or one of the places where formulas divide by zero.
enum class Family : std::uint8_t {
  ordinary,
  naked_eye,
  total_reflection,
  missed_rim,
  grazing,
  plano,
  concentric,
  nearly_concentric,
  power_through_zero,
  nearly_flat,
  focus_in_glass,
  focus_on_surface,
  focus_on_target,
  equal_eigenvalues,
  no_cylinder,
  axis_0_and_180,
  vertex_at_focus,
  extreme_distance,
  no_pupil,
  index_one,
  strong_surface,
  surface_ends,
  mounted,
  free_form
};

struct FamilyInfo {
  Family family;
  const char* name;
  double share;  ///< of the cases; they sum to 1
};

inline constexpr std::array<FamilyInfo, 24> families{{{Family::ordinary, "ordinary", 0.32},
                                                      {Family::naked_eye, "naked_eye", 0.05},
                                                      {Family::total_reflection, "total_reflection", 0.04},
                                                      {Family::missed_rim, "missed_rim", 0.02},
                                                      {Family::grazing, "grazing", 0.03},
                                                      {Family::plano, "plano", 0.03},
                                                      {Family::concentric, "concentric", 0.03},
                                                      {Family::nearly_concentric, "nearly_concentric", 0.04},
                                                      {Family::power_through_zero, "power_through_zero", 0.02},
                                                      {Family::nearly_flat, "nearly_flat", 0.03},
                                                      {Family::focus_in_glass, "focus_in_glass", 0.03},
                                                      {Family::focus_on_surface, "focus_on_surface", 0.03},
                                                      {Family::focus_on_target, "focus_on_target", 0.04},
                                                      {Family::equal_eigenvalues, "equal_eigenvalues", 0.02},
                                                      {Family::no_cylinder, "no_cylinder", 0.02},
                                                      {Family::axis_0_and_180, "axis_0_and_180", 0.02},
                                                      {Family::vertex_at_focus, "vertex_at_focus", 0.02},
                                                      {Family::extreme_distance, "extreme_distance", 0.03},
                                                      {Family::no_pupil, "no_pupil", 0.01},
                                                      {Family::index_one, "index_one", 0.02},
                                                      {Family::strong_surface, "strong_surface", 0.05},
                                                      {Family::surface_ends, "surface_ends", 0.02},
                                                      {Family::mounted, "mounted", 0.05},
                                                      {Family::free_form, "free_form", 0.03}}};

}  // namespace sturm::stress
