// Files made to break the readers of polyhedra: refused in bounded time and memory, never a crash.
#include <random>

#include "tests/formats/mesh.hpp"

namespace minkref::of_mesh_hostile {
namespace {

struct Sample {
  std::string title;
  MeshFormat format;
  std::string text;
};

/// A small good file of each format.
std::vector<Sample> samples() {
  std::vector<Sample> result;
  for (const MeshFormat format : mesh_formats) {
    result.push_back({name(format), format, write_mesh(tetrahedron(), format)});
  }
  result.push_back({"binary stl", MeshFormat::stl, binary_stl(tetrahedron())});
  result.push_back({"binary stl, solid", MeshFormat::stl, binary_stl(tetrahedron(), "solid")});
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    result.push_back({"binary ply", MeshFormat::ply, binary_ply(tetrahedron(), order, false)});
  }
  return result;
}

/// `text` is read, or refused as BadInput. Anything else fails.
void read_or_refuse(std::string_view text, MeshFormat format) {
  try {
    read_valid_mesh_text(text, format, "input");
  } catch (const BadInput& e) {
    EXPECT_FALSE(e.mend().empty());
    EXPECT_EQ(e.place().source, "input") << e.what();
    EXPECT_LT(std::string_view(e.what()).size(), 1000U);
  }
}

TEST(MeshHostile, AFileCutAtAnyByteIsReadOrRefused) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.title);
    EXPECT_NO_THROW(read_valid_mesh_text(sample.text, sample.format, "input"));
    for (std::size_t length = 0; length < sample.text.size(); ++length) {
      read_or_refuse(std::string_view(sample.text).substr(0, length), sample.format);
    }
  }
}

TEST(MeshHostile, ABinaryFileCutAnywhereIsRefused) {
  for (const Sample& sample : samples()) {
    if (!sample.title.starts_with("binary")) continue;
    for (std::size_t length = 0; length < sample.text.size(); ++length) {
      EXPECT_THROW(
          read_mesh_text(std::string_view(sample.text).substr(0, length), sample.format, ""),
          BadInput);
    }
  }
}

TEST(MeshHostile, AByteChangedToAnyOtherIsReadOrRefused) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.title);
    for (std::size_t at = 0; at < sample.text.size(); ++at) {
      std::string text = sample.text;
      for (int byte = static_cast<int>(at % 16); byte < 256; byte += 16) {
        text[at] = static_cast<char>(byte);
        read_or_refuse(text, sample.format);
      }
    }
  }
}

TEST(MeshHostile, RandomMutationsAreReadOrRefused) {
  const unsigned seed = 20260303;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const std::vector<Sample> all = samples();
  const std::vector<std::string> words = {"-1",   "4294967296", "1e9999", "nan", "0/0",
                                          "\n",   " ",          "\\\n",   "#",   "list",
                                          "face", "-",          "\r",     "\xff"};
  for (int round = 0; round < 20000; ++round) {
    const Sample& sample = all[random() % all.size()];
    std::string text = sample.text;
    for (std::size_t change = random() % 4 + 1; change > 0 && !text.empty(); --change) {
      const std::size_t at = random() % text.size();
      const std::size_t length = random() % 12;
      switch (random() % 4) {
        case 0:
          text.erase(at, length);
          break;
        case 1:
          text.insert(at, words[random() % words.size()]);
          break;
        case 2:
          text.insert(random() % text.size(), text.substr(at, 4 * length));
          break;
        default:
          text[at] = static_cast<char>(random() % 256);
      }
    }
    read_or_refuse(text, sample.format);
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << "round " << round << " of " << sample.title;
      return;
    }
  }
}

TEST(MeshHostile, AbsurdCountsAreRefusedWithoutMemory) {
  for (const std::string count : {"4000000000", "18446744073709551615"}) {
    EXPECT_EQ(mesh_code("OFF\n" + count + " 4 0\n0 0 0\n", MeshFormat::off), "truncated");
    EXPECT_EQ(mesh_code("OFF\n0 " + count + " 0\n", MeshFormat::off), "truncated");
    for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      const std::string format = "ply\nformat " + std::string(encoding) + " 1.0\n";
      const std::string xyz = "property uchar x\nproperty uchar y\nproperty uchar z\n";
      EXPECT_EQ(mesh_code(format + "element vertex " + count + "\n" + xyz + "end_header\n",
                          MeshFormat::ply),
                "truncated");
      EXPECT_EQ(mesh_code(format + "element face " + count +
                              "\nproperty list uint int vertex_index\nend_header\n",
                          MeshFormat::ply),
                "truncated");
      EXPECT_EQ(
          mesh_code(format + "element x " + count + "\nproperty list uint double l\nend_header\n",
                    MeshFormat::ply),
          "truncated");
      EXPECT_EQ(mesh_code(format + "element x " + count + "\nend_header\n", MeshFormat::ply),
                "syntax");
    }
  }
  const std::string list =
      "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint int vertex_index\n"
      "property list uint double more\nend_header\n";
  EXPECT_EQ(mesh_code(list + "\xff\xff\xff\xff", MeshFormat::ply), "truncated");
  const std::string face("\x03\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 16);
  EXPECT_EQ(mesh_code(list + face + "\xff\xff\xff\xff", MeshFormat::ply), "truncated");
}

TEST(MeshHostile, NumbersBeyondTheLimitsAreRefused) {
  const std::string number(1'000'000, '7');
  EXPECT_EQ(mesh_code("OFF 1 0 0\n0 0 " + number, MeshFormat::off), "number-too-long");
  EXPECT_EQ(mesh_code("v 0 0 1e1000000000", MeshFormat::obj), "exponent-too-large");
  ReadLimits limits;
  limits.number_bytes = 100'000;
  std::string text;
  for (int i = 0; i < 100; ++i) text += "v 1e9999 1e-9999 0\n";
  EXPECT_EQ(mesh_code(text, MeshFormat::obj, limits), "too-many-digits");
  limits.number_bytes = 100;
  EXPECT_EQ(mesh_code(binary_stl(tetrahedron()), MeshFormat::stl, limits), "too-many-digits");
}

TEST(MeshHostile, VerticesFacesAndTheirCornersHaveLimits) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.title);
    // STL has a vertex for each corner.
    const std::size_t vertices = sample.format == MeshFormat::stl ? 12 : 4;
    const auto limited = [&](std::size_t v, std::size_t f, std::size_t c) {
      ReadLimits limits;
      limits.vertices = v;
      limits.faces = f;
      limits.face_corners = c;
      return limits;
    };
    EXPECT_NO_THROW(read_valid_mesh_text(sample.text, sample.format, "", limited(vertices, 4, 12)));
    EXPECT_EQ(mesh_code(sample.text, sample.format, limited(vertices - 1, 4, 12)),
              "too-many-vertices");
    EXPECT_EQ(mesh_code(sample.text, sample.format, limited(vertices, 3, 12)), "too-many-faces");
    EXPECT_EQ(mesh_code(sample.text, sample.format, limited(vertices, 4, 11)),
              "too-many-face-corners");
    ReadLimits bytes;
    bytes.bytes = sample.text.size() - 1;
    EXPECT_EQ(mesh_code(sample.text, sample.format, bytes), "file-too-large");
  }
}

TEST(MeshHostile, TextBehindTheEndIsRefused) {
  for (const Sample& sample : samples()) {
    const std::string code = mesh_code(sample.text + "\nx", sample.format);
    // OBJ has no end; a length that does not fit belongs to no binary STL.
    EXPECT_EQ(code, sample.format == MeshFormat::obj ? "unknown-word" : "trailing-text")
        << sample.title;
  }
}

TEST(MeshHostile, OtherFilesAreRefused) {
  for (const MeshFormat format : mesh_formats) {
    for (const char* text : {"\x7f\x45\x4c\x46", "<svg/>", "\xff\xff\xff", "%PDF-1.7", "((((",
                             "}}}}", "solidity", "POLYGON EMPTY", "OFFLINE", "plyply"}) {
      EXPECT_THROW(read_valid_mesh_text(text, format, ""), BadInput) << name(format) << " " << text;
    }
    using namespace std::literals;
    EXPECT_EQ(mesh_code(" \r\n\t\n", format), "empty-file");
    EXPECT_EQ(mesh_code("\xFF\xFEO\0F\0F\0"sv, format), "not-utf8");
    if (format == MeshFormat::stl) continue;  // may hold NUL
    EXPECT_EQ(mesh_code("O\0F"sv, format), "nul-byte");
  }
}

TEST(MeshHostile, AHeaderOfManyLinesIsReadInLinearTime) {
  std::string text = "ply\nformat ascii 1.0\n";
  for (int i = 0; i < 200'000; ++i) text += "element e 0\nproperty int p\n";
  text += "element vertex 1\n";
  for (int i = 0; i < 200'000; ++i) text += "property int p" + std::to_string(i) + "\n";
  EXPECT_EQ(mesh_code(text + "end_header\n", MeshFormat::ply), "missing-property");
}

}  // namespace
}  // namespace minkref::of_mesh_hostile
