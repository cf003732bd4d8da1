#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <thread>

#include "io/files/atomic_file.h"
#include "io/io_testing.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::string failure_of(const fs::path& path, const std::string& bytes) {
  try {
    write_file_atomically(path, bytes);
  } catch (const RuntimeFailure& error) {
    return error.what();
  }
  ADD_FAILURE() << "no RuntimeFailure";
  return "";
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(AtomicFile, WritesInPiecesAndGoesBack) {
  const TemporaryFolder folder;
  std::string expected(1 << 20, 'a');
  AtomicFile file(folder / "a");
  file.write("....");
  for (int i = 0; i < 1 << 18; ++i) file.write("aaaa");  // more than the buffer holds, in small pieces
  EXPECT_EQ(file.position(), 4u + expected.size());
  file.seek(0);
  file.write("head");
  EXPECT_EQ(file.position(), 4u);
  file.commit();
  EXPECT_EQ(read_text(folder / "a"), "head" + expected);
}

TEST(AtomicFile, FollowsLinks) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "place");
  fs::create_symlink("place/target", folder / "first");
  fs::create_symlink(folder / "first", folder / "second");
  for (const char* text : {"made", "replaced"}) {
    write_file_atomically(folder / "second", text);
    EXPECT_TRUE(fs::is_symlink(folder / "second") && fs::is_symlink(folder / "first"));
    EXPECT_EQ(read_text(folder / "place/target"), text);
  }
  EXPECT_EQ(entries(folder / "place"), 1u);
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  EXPECT_THAT(failure_of(folder / "a", "x"), HasSubstr("circle"));
  fs::create_symlink("none/x", folder / "lost");
  EXPECT_THAT(failure_of(folder / "lost", "x"), HasSubstr("lost"));
  EXPECT_THAT(failure_of(folder / "place", "x"), HasSubstr("folder"));
}

TEST(AtomicFile, HandsDownPermissions) {
  const TemporaryFolder folder;
  write_text(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0600));
  write_file_atomically(folder / "a", "new");
  EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0600));
}

TEST(AtomicFile, WritesThroughPipesAndNeverReplacesThem) {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  { AtomicFile abandoned(pipe); }  // does not wait for a reader
  std::string received;
  std::thread reader([&] { received = read_text(pipe); });
  const std::string bytes(300000, 'x');  // more than a pipe holds
  AtomicFile file(pipe);
  file.write(bytes);
  file.seek(0);
  file.write("first");
  file.commit();
  reader.join();
  EXPECT_EQ(received, "first" + bytes.substr(5));
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(AtomicFile, DevicesStayWhatTheyAre) {
  EXPECT_THAT(failure_of("/dev/full", "x"), HasSubstr("No space left"));
  write_file_atomically("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/full") && fs::is_character_file("/dev/null"));
}

TEST(AtomicFile, OpenFilesAreWrittenOn) {
  const TemporaryFolder folder;
  const int file = ::open((folder / "log").c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
  ASSERT_EQ(::write(file, "before ", 7), 7);
  write_file_atomically("/dev/fd/" + std::to_string(file), "behind");
  ::close(file);
  EXPECT_EQ(read_text(folder / "log"), "before behind");
  const int read_only = ::open((folder / "log").c_str(), O_RDONLY);
  EXPECT_THAT(failure_of("/dev/fd/" + std::to_string(read_only), "x"), HasSubstr("Bad file descriptor"));
  ::close(read_only);
}

TEST(AtomicFile, LeavesNothingWhereThereIsNoRoom) {
  const TemporaryFolder folder;
  write_text(folder / "a", "old");
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = before;
  limit.rlim_cur = 1000;
  ::setrlimit(RLIMIT_FSIZE, &limit);
  const std::string failure = failure_of(folder / "a", std::string(1001, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(failure, HasSubstr("File too large"));
  EXPECT_EQ(read_text(folder / "a"), "old");
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(AtomicFile, AFailureIsNotForgotten) {
  AtomicFile file("/dev/full");
  file.write("x");
  EXPECT_THROW(file.commit(), RuntimeFailure);
  EXPECT_THROW(file.write("y"), RuntimeFailure);
  EXPECT_THROW(file.commit(), RuntimeFailure);
}

TEST(AtomicFile, TakesTheLongestNames) {
  const TemporaryFolder folder;
  const std::string name(255, 'x');
  write_file_atomically(folder / name, "text");
  EXPECT_EQ(read_text(folder / name), "text");
}

}  // namespace
}  // namespace sturm
