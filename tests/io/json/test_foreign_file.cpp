#include <gtest/gtest.h>

#include "io/json/foreign_file.h"

namespace sturm {
namespace {

TEST(ForeignFile, WhatPeopleMixUpWithDocuments) {
  for (const auto& [contents, kind] : {std::pair("\x89PNG\r\n\x1A\n", "a PNG picture"),
                                       {"\xFF\xD8\xFF\xE0", "a JPEG picture"},
                                       {"v/1\x01\x02", "an EXR picture"},
                                       {"#?RADIANCE\nFORMAT", "an HDR picture"},
                                       {"<svg xmlns='x'/>", "an XML, HTML or SVG file"},
                                       {"%PDF-1.4", "a PDF file"},
                                       {"id,eye,sph\n1,OD,-2\n", "a table (CSV)"},
                                       {"id;sph\r\n1;-2\r\n", "a table (CSV)"},
                                       {"# of a clinic\nid\tsph\n", "a table (CSV)"}})
    EXPECT_EQ(other_kind_of_file(contents), kind) << contents;
}

TEST(ForeignFile, WhatMayBeJson) {
  for (const char* contents :
       {"{\"a\": 1, \"b\": 2}", "[1, 2]", "", "\n{\"a\": 1}", "12", "{'a': 1,", "# a remark", "a: 1, b: 2"})
    EXPECT_EQ(other_kind_of_file(contents), "") << contents;
}

}  // namespace
}  // namespace sturm
