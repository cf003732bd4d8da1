#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/specs/notation_tokens.h"
#include "io/specs/prescription_notation.h"

namespace sturm {

/// Puts the tokens of a prescription together; parse_prescription_notation is its face.
class NotationParser {
 public:
  explicit NotationParser(std::vector<NotationToken> tokens) : tokens_(std::move(tokens)) {}

  std::vector<NotedPrescription> run();

 private:
  /// A power of one principal meridian: "-2.00 @ 180".
  struct Meridian {
    double power_D, angle_deg;
  };

  /// One eye's part of the text while it is read.
  struct Section {
    std::optional<EyeSide> eye;
    bool both_eyes = false, started = false;
    bool labels_come_first = false;   ///< "sph -2.00", not "-2.00 sph"
    bool sphere_is_labelled = false;  ///< said to be the sphere, not only the first number
    std::optional<double> sphere_D, cylinder_D, axis_deg, addition_D, vertex_distance_mm;
    std::vector<Meridian> meridians;
    NotedPrescription prism;  ///< its prism alone
  };

  const NotationToken* peek(std::size_t ahead = 0) const;
  bool is(std::size_t ahead, Term term) const;
  bool is_number(std::size_t ahead) const;
  bool skip(Term term);
  const NotationToken& expect_number(const char* what);
  double angle(const char* what, double largest);
  double dioptres(const NotationToken& number, const char* what, double largest) const;

  void start_section(std::optional<EyeSide> eye);
  void word();
  void number();
  void labelled(Term term, const NotationToken& number);
  void unlabelled(const NotationToken& number);
  void axis();
  void meridian_behind(const NotationToken& number);
  void addition(const NotationToken& number);
  void vertex_distance();
  void prism(const NotationToken& number);
  void base_then_prism();
  void add_prism(Term base, double amount);
  double prism_amount(const NotationToken& number) const;
  bool prism_follows() const;
  bool whole_prism_follows() const;
  std::optional<Term> named_base(std::size_t ahead) const;

  void finish_section();
  void finish_cross();
  std::string read_so_far() const;
  [[noreturn]] void fail(const std::string& expected) const;

  std::vector<NotationToken> tokens_;
  std::size_t at_ = 0;
  Section section_;
  std::vector<NotedPrescription> eyes_;
};

}  // namespace sturm
