#pragma once
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/io_testing.h"
#include "io/json/json_pointer_set.h"
#include "io/specs/experiment/experiment_spec.h"

namespace sturm {

/// An experiment in a folder of its own, read with one place set (/pointer=value).
class ExperimentDocumentTest : public ::testing::Test {
 protected:
  /// `file`: where the document would lie in the folder.
  explicit ExperimentDocumentTest(const std::string& file) : file_((folder_ / file).string()) {}

  /// The message of the InputError that it must throw.
  std::string error_with(const std::string& assignment) const {
    Json document = document_;
    apply_set(document, assignment);
    return input_error([&] { read_experiment(document, file_); });
  }

  TemporaryFolder folder_;
  std::string file_;
  Json document_;
};

}  // namespace sturm
