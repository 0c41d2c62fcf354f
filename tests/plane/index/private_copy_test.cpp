// A file's copy stays unchanged, in memory and as a separate file.
#include "reference/plane/index/private_copy.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "reference/error.hpp"

namespace minkref::testing::of_private_copy {
namespace {

class PrivateCopyOf : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  PrivateCopyOf()
      : folder_(std::filesystem::temp_directory_path() /
                ("minkref_copy_" + std::to_string(::getpid()))),
        path_(folder_ / "file") {
    std::filesystem::create_directory(folder_);
  }
  ~PrivateCopyOf() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
  static std::string text(const PrivateCopy& copy) {
    return {reinterpret_cast<const char*>(copy.bytes.data()), copy.bytes.size()};
  }

  std::filesystem::path folder_, path_;
};

TEST_P(PrivateCopyOf, AFileThatIsCutOffAndWrittenOverStaysAsItWas) {
  std::string bytes(9'000'001, 'x');
  for (std::size_t k = 0; k < bytes.size(); k += 4001) bytes[k] = static_cast<char>(k % 251);
  bytes.replace(0, 4, "head");
  write(bytes);
  const PrivateCopy copy = private_copy(path_, "head", GetParam());
  std::filesystem::resize_file(path_, 3);
  EXPECT_EQ(text(copy), bytes);
  write(std::string(bytes.size(), 'y'));
  EXPECT_EQ(text(copy), bytes);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    EXPECT_EQ(entry.path(), path_);
    ++files;
  }
  EXPECT_EQ(files, 1U);
}

TEST_P(PrivateCopyOf, AFileThatBeginsOtherwiseIsNotCopied) {
  for (const char* bytes : {"", "hea", "tail and more"}) {
    write(bytes);
    EXPECT_TRUE(private_copy(path_, "head", GetParam()).bytes.empty());
  }
}

TEST_P(PrivateCopyOf, WhatIsNoRegularFileIsRefused) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path :
       {folder_.string(), (folder_ / "absent").string(), pipe, std::string("/dev/zero")}) {
    try {
      private_copy(path, "head", GetParam());
      ADD_FAILURE() << path;
    } catch (const BadInput& refused) {
      EXPECT_EQ(refused.code(), "no-file");
      EXPECT_EQ(refused.place().source, path);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, PrivateCopyOf, ::testing::Values(0, std::uint64_t{1} << 30),
                         [](const auto& size) { return size.param == 0 ? "InAFile" : "InMemory"; });

}  // namespace
}  // namespace minkref::testing::of_private_copy
