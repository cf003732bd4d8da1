#include <gmock/gmock.h>

#include "io/io_testing.h"
#include "io/specs/prescription_table.h"

namespace sturm {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class PrescriptionTableFile : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& text) {
    write_text(folder_ / "eyes.csv", text);
    return folder_ / "eyes.csv";
  }
  std::string error(const std::string& text) {
    const auto name = file(text);
    return input_error([&] { read_prescription_table(name, 0.012); });
  }
  TemporaryFolder folder_;
};

TEST_F(PrescriptionTableFile, IsReadByTheNamesOfItsColumns) {
  // As spreadsheets write it: a byte order mark, CRLF, quotes.
  const auto eyes =
      read_prescription_table(file("\xEF\xBB\xBF# from a clinic, by hand\r\nid,note,axis_deg,eye,sph_D,cyl_D\r\n"
                                   "P1,\"old, \"\"lost\"\"\",30,OD,-2.25,-0.5\r\n\r\nP2,,180,OS,1,-1.75\r\n"),
                              0.012);
  ASSERT_EQ(eyes.size(), 2u);
  EXPECT_EQ(eyes[0].id, "P1-OD");
  EXPECT_EQ(eyes[0].prescription.sphere_D, -2.25);
  EXPECT_EQ(eyes[0].prescription.cylinder_D, -0.5);
  EXPECT_EQ(eyes[0].prescription.axis_deg, 30.0);
  EXPECT_EQ(eyes[0].prescription.vertex_distance_m, 0.012);
  EXPECT_EQ(eyes[1].id, "P2-OS");
  EXPECT_EQ(eyes[1].prescription.axis_deg, 180.0);
}

TEST_F(PrescriptionTableFile, WhatIsWrongIsNamedWithItsLine) {
  const std::string heading = "# note\neye,id,sph_D,cyl_D,axis_deg\n";
  EXPECT_THAT(
      error(heading + "OD,P1,-2.25,half,30\n"),
      AllOf(HasSubstr("eyes.csv"), HasSubstr("line 3"), HasSubstr("half"), HasSubstr("a number in column cyl_D")));
  EXPECT_THAT(error(heading + "OD,P1,1,0,30\n\nOD,P2,,0,30\n"),
              AllOf(HasSubstr("line 5"), HasSubstr("a value in column sph_D")));
  EXPECT_THAT(error(heading + "OD,P1,1\n"), AllOf(HasSubstr("line 3"), HasSubstr("a value in column cyl_D")));
  EXPECT_THAT(error(heading + "OD,P1,1,-1,nan\n"), AllOf(HasSubstr("line 3"), HasSubstr("OD,P1,1,-1,nan"),
                                                         HasSubstr("a prescription that can be computed")));
  EXPECT_THAT(error("eye,id,sph_D,axis_deg\nOD,P1,1,30\n"), HasSubstr("a column cyl_D"));
  EXPECT_THAT(error(heading), HasSubstr("a table with at least one prescription"));
  EXPECT_THAT(input_error([&] { read_prescription_table(folder_ / "none.csv", 0.012); }),
              AllOf(HasSubstr("none.csv"), HasSubstr("a file that can be read")));
  EXPECT_THAT(input_error([&] { read_prescription_table(folder_.path(), 0.012); }),
              HasSubstr("a file that can be read"));
}

}  // namespace
}  // namespace sturm
