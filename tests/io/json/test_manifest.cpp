#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/files/atomic_file.h"
#include "io/files/sha256.h"
#include "io/io_testing.h"
#include "io/json/manifest.h"
#include "io/json/schema.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

TEST(Sha256, MatchesTheTestVectorsOfFips180) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmno"
                   "pqrstnopqrstu"),
            "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfAFileIsThatOfItsBytes) {
  const TemporaryFolder folder;
  for (const std::size_t size : {0u, 55u, 56u, 63u, 64u, 65u, 119u, 120u, 70000u}) {
    const std::string bytes(size, 'x');
    write_text(folder / "a", bytes);
    EXPECT_EQ(sha256_of_file(folder / "a"), sha256(bytes)) << size;
  }
  EXPECT_THAT(input_error([&] { sha256_of_file(folder / "none"); }), HasSubstr("none"));
}

TEST(AtomicFile, AppearsCompleteOrNotAtAll) {
  const TemporaryFolder folder;
  {
    AtomicFile abandoned(folder / "a.txt");
    write_text(abandoned.temporary(), "half");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    EXPECT_EQ(abandoned.temporary().parent_path(), folder.path());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  write_file_atomically(folder / "a.txt", "one");
  write_file_atomically(folder / "a.txt", std::string("t\0wo", 4));
  EXPECT_EQ(read_text(folder / "a.txt"), std::string("t\0wo", 4));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_THROW(write_file_atomically(folder / "none/a.txt", "x"), RuntimeFailure);
  EXPECT_THROW(write_file_atomically("/dev/full/a.txt", "x"), RuntimeFailure);
}

TEST(AtomicFile, TwoWritersOfOneNameDoNotShareATemporaryFile) {
  const TemporaryFolder folder;
  AtomicFile a(folder / "a.txt"), b(folder / "a.txt");
  EXPECT_NE(a.temporary(), b.temporary());
}

TEST(Manifest, FollowsItsSchema) {
  const TemporaryFolder folder;
  write_text(folder / "in.txt", "abc");
  RunFacts run;
  run.threads = 2;
  run.seed = 9007199254740991u;
  run.started_utc = utc_now();
  run.seconds = {{"total", 1.5}};
  run.input_files = {(folder / "in.txt").string()};
  const Json document = manifest(run, {{"b", 1}, {"a", 2}}, {{"dropped", 0}}, {"wide pupil"});
  EXPECT_NO_THROW(validate(document, "manifest", "m.json"));
  EXPECT_EQ(document["provenance"]["inputs"][0]["sha256"],
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(document["provenance"]["spec_hash"], sha256("{\"a\":2,\"b\":1}"));
  EXPECT_EQ(document["provenance"]["seed"], 9007199254740991u);
  EXPECT_THAT(run.started_utc, MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z"));
  EXPECT_FALSE(cpu_model().empty());
  EXPECT_THAT(instruction_set(), ::testing::StartsWith("x86-64"));
}

}  // namespace
}  // namespace sturm
