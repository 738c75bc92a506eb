#include "core/base/file.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace alhazen {
namespace {

class FileTest : public testing::Test {
 protected:
  FileTest() {
    folder_ = std::filesystem::temp_directory_path() /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~FileTest() override { std::filesystem::remove_all(folder_); }

  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  std::filesystem::path folder_;
};

TEST_F(FileTest, WrittenBytesAreReadBack) {
  const std::string bytes("a\0b\n", 4);
  ASSERT_TRUE(write_file_atomic(folder_ / "f", bytes));
  const Result<std::string> read = read_file(folder_ / "f", 4);
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value(), bytes);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileTest, FileOverTheLimitIsALimitError) {
  ASSERT_TRUE(write_file_atomic(folder_ / "f", "12345"));
  const Result<std::string> read = read_file(folder_ / "f", 4);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::limit);
}

TEST_F(FileTest, FolderAndMissingFileAreIoErrors) {
  EXPECT_EQ(read_file(folder_, 10).error().code, ErrorCode::io);
  EXPECT_EQ(read_file(folder_ / "missing", 10).error().code, ErrorCode::io);
  EXPECT_EQ(write_file_atomic(folder_ / "missing" / "f", "x").error().code, ErrorCode::io);
  EXPECT_EQ(write_file_atomic(folder_, "x").error().code, ErrorCode::io);
}

TEST_F(FileTest, AbandonedFileLeavesTheOldOneAndNothingElse) {
  ASSERT_TRUE(write_file_atomic(folder_ / "f", "old"));
  {
    Result<AtomicFile> file = AtomicFile::create(folder_ / "f");
    ASSERT_TRUE(file);
    EXPECT_EQ(entries(), 2u);
  }
  EXPECT_EQ(entries(), 1u);
  EXPECT_EQ(read_file(folder_ / "f", 10).value(), "old");
}

TEST_F(FileTest, LinksStayAndWhatTheyLeadToIsWritten) {
  std::filesystem::create_directory(folder_ / "sub");
  std::filesystem::create_symlink("second", folder_ / "first");
  std::filesystem::create_symlink("sub/f", folder_ / "second");
  for (const char* bytes : {"to a file that is not there yet", "to one that is"}) {
    ASSERT_TRUE(write_file_atomic(folder_ / "first", bytes));
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "first"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "second"));
    EXPECT_EQ(read_file(folder_ / "sub/f", 100).value(), bytes);
  }
  std::filesystem::create_symlink("loop", folder_ / "loop");
  EXPECT_EQ(write_file_atomic(folder_ / "loop", "x").error().code, ErrorCode::io);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "loop"));
}

TEST_F(FileTest, TheLongestNameIsWritten) {
  const std::string longest(255, 'n');  // NAME_MAX
  EXPECT_TRUE(write_file_atomic(folder_ / longest, "x"));
  EXPECT_EQ(entries(), 1u);
}

// A program that opened a pipe without a writer, or replaced it by a file, would not get this far.
TEST_F(FileTest, DevicesAndNamedPipesAreRefused) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), S_IRUSR | S_IWUSR), 0);
  EXPECT_EQ(read_file(folder_ / "pipe", 10).error().code, ErrorCode::io);
  EXPECT_EQ(write_file_atomic(folder_ / "pipe", "x").error().code, ErrorCode::io);
  EXPECT_TRUE(std::filesystem::is_fifo(folder_ / "pipe"));
  EXPECT_EQ(AtomicFile::create("/dev/null").error().code, ErrorCode::io);
  EXPECT_EQ(entries(), 1u);
}

}  // namespace
}  // namespace alhazen
