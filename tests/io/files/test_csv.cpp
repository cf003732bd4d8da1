#include <gmock/gmock.h>

#include <limits>

#include "io/files/csv.h"
#include "io/io_testing.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Rows = std::vector<std::vector<std::string>>;

Rows rows_of(std::string_view text, CsvDialect dialect = {}) {
  CsvReader reader(text, "table.csv", dialect);
  Rows rows;
  while (const auto row = reader.next()) rows.push_back(row->fields);
  return rows;
}

std::string error(std::string_view text) {
  return input_error([&] { rows_of(text); });
}

TEST(CsvReader, CutsAtSeparatorsAndEitherLineEnd) {
  EXPECT_THAT(rows_of("a,b,c\r\n1,,3\n4,5,"),
              ElementsAre(ElementsAre("a", "b", "c"), ElementsAre("1", "", "3"), ElementsAre("4", "5", "")));
  EXPECT_THAT(rows_of(""), ElementsAre());
  EXPECT_THAT(rows_of(","), ElementsAre(ElementsAre("", "")));
}

TEST(CsvReader, QuotesHoldSeparatorsLineEndsAndQuotes) {
  EXPECT_THAT(rows_of("\"a,b\",\"c \"\"d\"\"\"\r\n\"e\r\nf\",\"\" , \" g \"\r\n"),
              ElementsAre(ElementsAre("a,b", "c \"d\""), ElementsAre("e\r\nf", "", " g ")));
  EXPECT_THAT(rows_of("5\" lens,x"), ElementsAre(ElementsAre("5\" lens", "x")));  // only a first character opens quotes
}

TEST(CsvReader, LeavesOutWhatIsNoRow) {
  EXPECT_THAT(rows_of("\xEF\xBB\xBF# a note, \"half quoted\n\n \t\r\na , b\t\n#,\n1,#2\n"),
              ElementsAre(ElementsAre("a", "b"), ElementsAre("1", "#2")));
}

TEST(CsvReader, AByteOrderMarkIsNotPartOfTheFirstField) {
  EXPECT_THAT(rows_of("\xEF\xBB\xBFx_mm,y_mm\n"), ElementsAre(ElementsAre("x_mm", "y_mm")));
}

TEST(CsvReader, RowsKnowTheirLineAndText) {
  CsvReader reader("# note\r\na,\"b\nc\"\r\n\r\nd, e\r\nf", "table.csv");
  const auto first = *reader.next(), second = *reader.next(), third = *reader.next();
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(first.line, 2);
  EXPECT_EQ(second.line, 5);  // the first row took two lines
  EXPECT_EQ(third.line, 6);
  EXPECT_EQ(first.text, "a,\"b\nc\"");
  EXPECT_EQ(second.text, "d, e");
  EXPECT_EQ(third.text, "f");
}

TEST(CsvReader, TheDialectSaysWhichCharacters) {
  EXPECT_THAT(rows_of("1,5;'a;b'''\n", {';', '\''}), ElementsAre(ElementsAre("1,5", "a;b'")));
  EXPECT_THAT(rows_of("a\t\tb \n", {'\t', '"'}), ElementsAre(ElementsAre("a", "", "b")));
}

TEST(CsvReader, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_THAT(error("a,b\n1,\"two\nthree\n"),
              AllOf(HasSubstr("table.csv"), HasSubstr("line 2"), HasSubstr("\"two"), HasSubstr("a closing quote")));
  EXPECT_THAT(error("a,b\n\"1\n2\"3,4\n"), AllOf(HasSubstr("line 3"), HasSubstr("3,4"), HasSubstr("closing quote")));
}

TEST(CsvReader, CarriageReturnsAloneEndRows) {
  EXPECT_THAT(rows_of("a,b\r1,2\r\r3,4"),
              ElementsAre(ElementsAre("a", "b"), ElementsAre("1", "2"), ElementsAre("3", "4")));
  CsvReader reader("a\r\r\nb\rc\n\"d\re\"\nf", "table.csv");
  for (const int line : {1, 3, 4, 5, 7}) EXPECT_EQ(reader.next()->line, line);
}

TEST(CsvDialect, IsToldFromTheHeading) {
  EXPECT_EQ(csv_dialect_of("a,b\n1;2\n").separator, ',');
  EXPECT_EQ(csv_dialect_of("# one, two\n\r\n\"a,b\";c\n").separator, ';');
  EXPECT_EQ(csv_dialect_of("a, b\tc\n").separator, '\t');
  EXPECT_EQ(csv_dialect_of("x_mm  y_mm z_mm\n").separator, ' ');
  EXPECT_EQ(csv_dialect_of("alone\n").separator, ',');
  EXPECT_EQ(csv_dialect_of("\xEF\xBB\xBFsep=;\r\na,b\n").separator, ';');
  EXPECT_EQ(csv_dialect_of("sep=|\na,x|b\n").separator, '|');
  EXPECT_EQ(csv_dialect_of("").separator, ',');
}

TEST(CsvReader, BlanksSeparateInRuns) {
  EXPECT_THAT(rows_of(" a  b\tc \n1   -2 3\n", {' ', '"'}),
              ElementsAre(ElementsAre("a", "b", "c"), ElementsAre("1", "-2", "3")));
}

TEST(CsvReader, TheLineThatNamesTheSeparatorIsNoRow) {
  EXPECT_THAT(rows_of("sep=;\r\na;b\r\n", {';', '"'}), ElementsAre(ElementsAre("a", "b")));
}

TEST(CsvNumber, IsAllOfTheField) {
  EXPECT_EQ(csv_number("-0.25"), -0.25);
  EXPECT_EQ(csv_number("2e-3"), 0.002);
  EXPECT_EQ(csv_number("inf"), std::numeric_limits<double>::infinity());
  for (const char* text : {"", "1,2,5", "1.000,5", "1.5 D", " 1", "+-1", "++1", "-", "+", "0x10", "one"})
    EXPECT_FALSE(csv_number(text)) << text;
}

TEST(CsvNumber, IsAsPeopleTypeIt) {
  for (const char* text : {"+1.25", "1,25", "+1,25", "1.25", "+1.25e0", "\uFF0B1.25"})
    EXPECT_EQ(csv_number(text), 1.25) << text;
  for (const char* text : {"-0.5", "\u22120.5", "\u20130,5", "-,5", "-.5"}) EXPECT_EQ(csv_number(text), -0.5) << text;
}

TEST(CsvWriter, WritesWhatTheReaderReads) {
  CsvWriter csv;
  for (const char* text : {"plain", "a,b", "", "\"quoted\"", "two\r\nlines"}) csv.text(text);
  csv.end_row();
  csv.number(0.1 + 0.2);
  csv.number(1.0 / 3.0, 9);
  csv.number(-std::numeric_limits<double>::infinity());
  csv.number(std::nullopt);
  csv.empty(1);
  csv.end_row();
  EXPECT_EQ(csv.table(),
            "plain,\"a,b\",,\"\"\"quoted\"\"\",\"two\r\nlines\"\r\n0.30000000000000004,0.333333333,-inf,,\r\n");
  EXPECT_THAT(rows_of(csv.table()), ElementsAre(ElementsAre("plain", "a,b", "", "\"quoted\"", "two\r\nlines"),
                                                ElementsAre("0.30000000000000004", "0.333333333", "-inf", "", "")));
}

}  // namespace
}  // namespace sturm
