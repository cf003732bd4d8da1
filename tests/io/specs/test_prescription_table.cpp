#include <gmock/gmock.h>

#include "io/io_testing.h"
#include "io/specs/prescription_table.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class PrescriptionTableFile : public ::testing::Test {
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

TEST_F(PrescriptionTableFile, WithoutEyesTheIdAloneIsTheName) {
  for (const char* text : {"id,sph,cyl,axis\nP1,-2.00,-0.50,30\n", "id,rx\nP1,-2.00 -0.50 x 30\n"}) {
    const auto eyes = read_prescription_table(file(text), 0.012);
    ASSERT_EQ(eyes.size(), 1u) << text;
    EXPECT_EQ(eyes[0].id, "P1") << text;
    EXPECT_EQ(eyes[0].prescription.cylinder_D, -0.5) << text;
  }
  EXPECT_THAT(error("eye,sph,cyl,axis\nOD,-2,,\n"), HasSubstr("a column id (or patient, subject, name, number)"));
  EXPECT_THAT(error("id,eye,sph,cyl,axis\nP1,,-2,,\n"), HasSubstr("a value in column eye"));
}

/// The one eye of a table of one row.
Prescription only(const std::vector<TabledPrescription>& eyes) {
  EXPECT_EQ(eyes.size(), 1u);
  return eyes.at(0).prescription;
}

TEST_F(PrescriptionTableFile, IsReadAsPeopleWriteIt) {
  // One eye, −2.00 −0.50 × 30, by everyone's spreadsheet.
  for (const char* text : {
           "eye,id,sph_D,cyl_D,axis_deg\nOD,P1,-2.00,-0.50,30\n",
           "Eye;ID;Sph;Cyl;Axis\r\nOD;P1;-2,00;-0,50;30\r\n",
           "eye\tid\tSphere (D)\tCylinder (D)\tAxis (\u00B0)\nOD\tP1\t-2,00\t-0,50\t30\n",
           "eye,id,sph_D,cyl_D,axis_deg\rOD,P1,-2,-0.5,030\r",
           "\"eye\",\"id\",\"sph_D\",\"cyl_D\",\"axis_deg\"\n\"OD\",\"P1\",\"-2,00\",\"-0,50\",\"30\"\n",
           "sep=;\neye;id;sph;zyl;achse\nOD;P1;\u22122,00;\u22120,50;30\u00B0\n",
           " EYE , Id , SPH_D , CYL_D , AXIS_DEG \n\n# from a clinic\n OD , P1 , -2.00 DS , -0.50 DC , x 30 \n,,,,\n",
           "eye,id,sph_D,cyl_D,axis_deg,,\nOD,P1,-2.00,-0.50,30,,\n",
           "eye,id,rx\nOD,P1,-2.00 -0.50 x 30\n",
           "id;prescription\nP1;OD -2,00 -0,50 x 30\n",
           "eye,id,rx\nright,P1,OD -2.00/-0.50x30 OS +1.00 DS\n",
       }) {
    const auto eyes = read_prescription_table(file(text), 0.012);
    const Prescription rx = only(eyes);
    EXPECT_EQ(rx.sphere_D, -2.0) << text;
    EXPECT_EQ(rx.cylinder_D, -0.5) << text;
    EXPECT_EQ(rx.axis_deg, 30.0) << text;
    EXPECT_EQ(rx.vertex_distance_m, 0.012) << text;
    EXPECT_EQ(eyes[0].id.substr(0, 3), "P1-") << text;
  }
}

TEST_F(PrescriptionTableFile, IsReadInTheEncodingsOfSpreadsheets) {
  std::string utf16 = "\xFF\xFE";
  for (const char c : std::string("eye\tid\tsph\tcyl\taxis\r\nOS\tP2\t+1,25\t\t\r\n")) utf16 += c, utf16 += '\0';
  EXPECT_EQ(only(read_prescription_table(file(utf16), 0.012)).sphere_D, 1.25);
  // Latin-1: a name with an umlaut.
  const auto eyes = read_prescription_table(file("eye;id;sph;cyl;axis\nOD;M\xFCller;-1;;\n"), 0.012);
  EXPECT_EQ(eyes.at(0).id, "M\u00FCller-OD");
}

TEST_F(PrescriptionTableFile, ASphereLeavesCylinderAndAxisEmpty) {
  for (const char* cells :
       {"+1.25,,", "1.25,0,", "+1.25,DS,", "+1.25,-,-", "+1.25,SPH,", "+1.25,Ds,", "+1.25,0.00,90"}) {
    const Prescription rx =
        only(read_prescription_table(file(std::string("eye,id,sph_D,cyl_D,axis_deg\nOD,P1,") + cells + "\n"), 0.012));
    EXPECT_EQ(rx.sphere_D, 1.25) << cells;
    EXPECT_EQ(rx.cylinder_D, 0.0) << cells;
  }
  for (const std::string cell : {"PL", "plano", "Plan", "PLN"})
    EXPECT_EQ(only(read_prescription_table(file("eye,id,sph_D,cyl_D,axis_deg\nOD,P1," + cell + ",-0.75,180\n"), 0.0))
                  .sphere_D,
              0.0)
        << cell;
}

TEST_F(PrescriptionTableFile, BothEyesOfATextAndItsVertexDistance) {
  const auto eyes = read_prescription_table(file("id,rx\nP1,OD -2.00 DS VD 14 OS PL -0.75 x 180\n"), 0.012);
  ASSERT_EQ(eyes.size(), 2u);
  EXPECT_EQ(eyes[0].id, "P1-OD");
  EXPECT_DOUBLE_EQ(eyes[0].prescription.vertex_distance_m, 0.014);
  EXPECT_EQ(eyes[1].id, "P1-OS");
  EXPECT_EQ(eyes[1].prescription.cylinder_D, -0.75);
  EXPECT_EQ(eyes[1].prescription.vertex_distance_m, 0.012);
  EXPECT_DOUBLE_EQ(
      only(read_prescription_table(file("eye,id,sph,cyl,axis,BVD (mm)\nOD,P1,-2,,,13\n"), 0.012)).vertex_distance_m,
      0.013);
}

TEST_F(PrescriptionTableFile, WhatCouldBeMisreadIsRefused) {
  const std::string heading = "eye,id,sph_D,cyl_D,axis_deg\n";
  // A decimal comma between commas would make a cylinder of 25 D.
  EXPECT_THAT(error(heading + "OD,P1,-1,25,-0,75,80\n"), AllOf(HasSubstr("line 2"), HasSubstr("at most 5 fields")));
  EXPECT_THAT(error(heading + "OD,P1,-1.25,-0.75,\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("axis_deg, which a cylinder needs")));
  EXPECT_THAT(error(heading + "OD,P1,-1.25,-0.75,190\n"), HasSubstr("axis [deg] is 190, expected 0 to 180"));
  EXPECT_THAT(error(heading + "OD,P1,-40.0000001,0,\n"), HasSubstr("sphere [D] is -40.0000001, expected -40 to 40"));
  // Where the heading has names left for the shifted fields, the decimals give it away.
  const std::string wide = "id,eye,sph,cyl,axis,va,note\n";
  EXPECT_THAT(error(wide + "P1,OD,-1,25,-0,75,80\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("25"), HasSubstr("column cyl_D"), HasSubstr("hundredths")));
  EXPECT_THAT(error(wide + "P1,OD,-1,00,0,00,0\n"), HasSubstr("got 00"));
  EXPECT_THAT(error(wide + "P1,OD,-1,5,-0,75,80\n"), AllOf(HasSubstr("got -0"), HasSubstr("axis_deg")));
  EXPECT_THAT(error(heading + "OD,P1,-075,,\n"), AllOf(HasSubstr("got -075"), HasSubstr("hundredths")));
  EXPECT_THAT(error(heading + "OD,P1,+25 D,,\n"), HasSubstr("hundredths"));
  EXPECT_EQ(only(read_prescription_table(file(heading + "OD,P1,-12,-3,0\n"), 0.0)).sphere_D, -12.0);
  EXPECT_THAT(error("eye,id,sph,Sphere,cyl,axis\nOD,P1,1,2,,\n"),
              AllOf(HasSubstr("\"sph\" and \"Sphere\""), HasSubstr("one column for sph_D")));
  EXPECT_THAT(error("eye,id,rx\nOD,P1,-2.00 -1.50\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("an axis behind the cylinder")));
  EXPECT_THAT(error("eye,id,rx\nOD,P1,OS -2.00 DS\n"), HasSubstr("the prescription of the right eye"));
  EXPECT_THAT(error("eye,id,rx\nOD,P1,-2.00 DS 2^ BI\n"), HasSubstr("no prism"));
  EXPECT_THAT(error("eye,id,rx,sph\nOD,P1,-2.00 DS,1\n"), HasSubstr("a column rx, or columns"));
}

}  // namespace
}  // namespace sturm
