// Files are read to their end, and told apart by their extension.
#include "formats/file_text.hpp"
#include "formats/write.hpp"
#include "tests/formats/refusal.hpp"
#include "tests/formats/temporary_folder.hpp"

namespace minkref::of_file {
namespace {

std::string code_of_file(const std::string& path, const ReadLimits& limits = {}) {
  const BadInput refused = refusal_of([&] { read_valid_file(path, limits); });
  EXPECT_EQ(refused.place().source, path) << refused.what();
  return refused.code();
}

TEST(File, TheExtensionNamesTheFormat) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_valid_file(folder.file("a.wkt", "POINT (1 2)")).set.is_point());
  EXPECT_TRUE(read_valid_file(folder.file("a.WKT", "POINT (1 2)")).set.is_point());
  const std::string geojson = R"({"type":"Point","coordinates":[1,2]})";
  EXPECT_TRUE(read_valid_file(folder.file("a.geojson", geojson)).set.is_point());
  EXPECT_TRUE(read_valid_file(folder.file("a.json", geojson)).set.is_point());
  EXPECT_EQ(read_valid_file(folder.file("a.poly", "1\n3 out\n0 0\n1 0\n0 1\n")).set.vertices(), 3U);
  EXPECT_EQ(code_of_file(folder.file("a.txt", "POINT (1 2)")), "unknown-format");
  EXPECT_EQ(code_of_file(folder.file("a", "POINT (1 2)")), "unknown-format");
  EXPECT_EQ(code_of_file(folder.file("a.svg", "<svg/>")), "unknown-format");
}

TEST(File, FormatsHaveOneNameEach) {
  for (const Format format :
       {Format::wkt, Format::geojson, Format::poly, Format::json, Format::case_json, Format::svg}) {
    EXPECT_EQ(format_named(name(format)), format);
  }
  EXPECT_EQ(refusal_of([] { format_named("dxf"); }).code(), "unknown-format");
}

TEST(File, WhatCannotBeReadIsRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(code_of_file(folder.path("missing.wkt")), "cannot-read");
  EXPECT_EQ(code_of_file(folder.path("missing")), "cannot-read");
  std::filesystem::create_directory(folder.path("directory.wkt"));
  EXPECT_EQ(code_of_file(folder.path("directory.wkt")), "cannot-read");
}

TEST(File, EmptyFilesAreRefused) {
  const TemporaryFolder folder;
  for (const char* name : {"a.wkt", "a.geojson", "a.json", "a.poly"}) {
    EXPECT_EQ(code_of_file(folder.file(name, "")), "empty-file");
    EXPECT_EQ(code_of_file(folder.file(name, " \r\n\t\n")), "empty-file");
    EXPECT_EQ(code_of_file(folder.file(name, "\xEF\xBB\xBF")), "empty-file");
  }
}

TEST(File, AFileBeyondTheLimitIsRefused) {
  const TemporaryFolder folder;
  ReadLimits limits;
  limits.bytes = 20;
  EXPECT_TRUE(read_file(folder.file("a.wkt", "POINT (1 2)         "), limits).set.is_point());
  EXPECT_EQ(code_of_file(folder.file("b.wkt", "POINT (1 2)          "), limits), "file-too-large");
  EXPECT_EQ(code_of_file("/dev/zero", limits), "file-too-large");
}

TEST(File, AByteOrderMarkIsSkippedAndUtf16Refused) {
  using namespace std::literals;
  EXPECT_TRUE(read_text("\xEF\xBB\xBFPOINT (1 2)", Format::wkt, "").set.is_point());
  EXPECT_TRUE(read_text("\xEF\xBB\xBF{\"polygons\":[]}", Format::json, "").set.empty());
  EXPECT_EQ(code_of("\xFF\xFEP\0O\0"sv, Format::wkt), "not-utf8");
  EXPECT_EQ(code_of("\xFE\xFF\0P\0O"sv, Format::wkt), "not-utf8");
}

TEST(File, ANulByteIsRefusedWithItsLine) {
  using namespace std::literals;
  const BadInput refused = refusal_of_text("POINT\n(1 2)\n\0"sv, Format::wkt);
  EXPECT_EQ(refused.code(), "nul-byte");
  EXPECT_EQ(refused.place().line, 3U);
}

TEST(File, WritingToNoFolderIsRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal_of([&] { write_file("", folder.path("no/such/folder.wkt")); }).code(),
            "cannot-write");
  write_file("POINT (1 2)\n", folder.path("a.wkt"));
  EXPECT_EQ(read_whole_file(folder.path("a.wkt")), "POINT (1 2)\n");
}

}  // namespace
}  // namespace minkref::of_file
