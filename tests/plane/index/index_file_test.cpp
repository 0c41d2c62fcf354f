// An index comes back unchanged from its file; other files are refused.
#include <gtest/gtest.h>

#include <boost/crc.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "reference/error.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_index_file {
namespace {

class IndexFile : public ::testing::Test {
 protected:
  IndexFile()
      : path_(std::filesystem::temp_directory_path() /
              ("minkref_index_" + std::to_string(::getpid()) + ".index")) {}
  ~IndexFile() override { std::filesystem::remove(path_); }

  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
  std::string refusal() const {
    try {
      ScaleIndex::open(path_);
    } catch (const BadInput& refused) {
      EXPECT_NE(std::string(refused.what()).find(path_.string()), std::string::npos);
      return refused.code();
    }
    return "";
  }

  std::filesystem::path path_;
};

PolygonSet with_hole() {
  PolygonSet set = box(-40, -40, 40, 40);
  set.polygons[0].holes.push_back({{0, 20}, {17, -11}, {-19, -9}});
  return set;
}
PolygonSet triangle() { return {{{{{-3, -2}, {4, -1}, {1, 3}}, {}}}}; }

TEST_F(IndexFile, GivesTheSameAnswers) {
  MINKREF_SEEDED(random, 940);
  expect_law(random, 20, [&](const Case& c) -> std::string {
    const ScaleIndex built(c.P, c.Q, {c.scale / 2, c.scale * 2});
    built.save(path_);
    const ScaleIndex loaded = ScaleIndex::open(path_);
    if (loaded.P() != c.P || loaded.Q() != c.Q) return "other operands";
    if (loaded.window().from != built.window().from || loaded.window().to != built.window().to) {
      return "another window";
    }
    if (loaded.edges() != reduced_convolution(c.P, c.Q)) return "other edges";
    for (const Rational& scale :
         {Rational(c.scale / 2), c.scale, Rational(c.scale * 2), Rational(c.scale * 7 / 5)}) {
      if (built.sum(scale).region != loaded.sum(scale).region) return "another sum";
    }
    if (built.timeline().topology.size() != loaded.timeline().topology.size()) return "events";
    return "";
  });
}

TEST_F(IndexFile, AnyBitThatChangesIsSeen) {
  ScaleIndex(triangle(), with_hole(), {Rational(1), Rational(4)}).save(path_);
  const std::string whole = bytes();
  ASSERT_EQ(refusal(), "");
  for (std::size_t k = 0; k < whole.size(); k += 1 + whole.size() / 300) {
    std::string damaged = whole;
    damaged[k] = static_cast<char>(damaged[k] ^ 1 << k % 8);
    write(damaged);
    EXPECT_NE(refusal(), "") << "byte " << k;
  }
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{7}, whole.size() / 2, whole.size() - 1}) {
    write(whole.substr(0, size));
    EXPECT_NE(refusal(), "") << "the first " << size << " bytes";
  }
  write(whole + "more");
  EXPECT_EQ(refusal(), "damaged-index");
}

/// Changes a word and corrects the checksum.
std::string forged(std::string bytes, std::size_t word, std::uint32_t value) {
  constexpr std::size_t checksum_at = 24;
  const auto put = [&](std::size_t at, std::uint32_t number) {
    std::memcpy(bytes.data() + at, &number, sizeof number);
  };
  put(4 * word, value);
  put(checksum_at, 0);
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  put(checksum_at, crc.checksum());
  return bytes;
}

TEST_F(IndexFile, AForgedOneIsNeverTakenForAFaultOfOurs) {
  const PolygonSet bar = box(0, 0, 3, 1);
  const PolygonSet hook = region({{0, 0}, {5, 0}, {5, 5}, {3, 5}, {3, 2}, {2, 2}, {2, 5}, {0, 5}});
  const ScaleIndex built(bar, hook, {Rational(1, 4), Rational(4)});
  built.save(path_);
  const std::string whole = bytes();
  std::size_t opened = 0, refused = 0;
  for (std::size_t word = 8; word < whole.size() / 4; word += 3) {
    write(forged(whole, word, static_cast<std::uint32_t>(word % 4)));
    try {
      const ScaleIndex index = ScaleIndex::open(path_);
      ++opened;
      for (std::uint32_t k = 0; k < index.events(); ++k) {
        index.sum(index.event(k), Passages::find);
      }
    } catch (const BadInput& refusal) {
      ++refused;
    } catch (const std::exception& fault) {
      ADD_FAILURE() << fault.what() << " after a change of word " << word;
    }
  }
  EXPECT_GT(opened, 100U);
  EXPECT_GT(refused, 50U);
}

TEST_F(IndexFile, WhatIsForeignIsNamedSo) {
  EXPECT_EQ(refusal(), "no-file");
  write(std::string(5000, 'x'));
  EXPECT_EQ(refusal(), "not-an-index");
  ScaleIndex(triangle(), with_hole(), {Rational(1), Rational(4)}).save(path_);
  std::string later = bytes();
  later[8] = 2;
  write(later);
  EXPECT_EQ(refusal(), "index-version");
}

TEST_F(IndexFile, NothingIsWrittenWhereItCannotBe) {
  const ScaleIndex index(triangle(), with_hole(), {Rational(1), Rational(4)});
  EXPECT_THROW(index.save(path_.string() + ".no/such/folder"), BadInput);
  EXPECT_FALSE(std::filesystem::exists(path_));
}

}  // namespace
}  // namespace minkref::testing::of_index_file
