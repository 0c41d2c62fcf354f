// Writing and reading a polyhedron gives the same polyhedron.
#include <random>

#include "tests/formats/mesh.hpp"
#include "tests/formats/temporary_folder.hpp"

namespace minkref::of_mesh_write {
namespace {

const std::string fifty = "12345678901234567890123456789.012345678901234567891";

Polyhedron long_decimals() {
  return tetrahedron(space_point("0.1", "-0.25", "0"), space_point("0", fifty.c_str(), "0"),
                     space_point("1", "1e-30", "1e-3"), space_point("0", "0", fifty.c_str()));
}

Polyhedron fractions() {
  return tetrahedron(space_point("1/3", "0", "0"), space_point("0", "10/7", "0"),
                     space_point("22/7", "0", "1/9"), space_point("0", "0", "355/113"));
}

std::vector<Polyhedron> operands() {
  return {{},
          {{space_point("0.5", "-2", "3")}, {}},
          {{space_point("0", "0", "0"), space_point("1e-3", "7", "1e400")}, {}},
          cube(),
          tetrahedron(),
          long_decimals(),
          fractions()};
}

TEST(MeshWrite, EveryPolyhedronIsReadBackFromEveryFormatThatIsExact) {
  for (const Polyhedron& polyhedron : operands()) {
    for (const MeshFormat format : mesh_formats) {
      if (!writes_exactly(polyhedron, format)) continue;
      const std::string text = write_mesh(polyhedron, format);
      EXPECT_EQ(text.back(), '\n');
      EXPECT_EQ(mesh_in(text, format), polyhedron) << name(format) << ": " << text;
    }
  }
}

TEST(MeshWrite, DecimalsAreExactInEveryFormatAndFractionsInJson) {
  for (const MeshFormat format : mesh_formats) {
    EXPECT_TRUE(writes_exactly(tetrahedron(), format)) << name(format);
    EXPECT_TRUE(writes_exactly(long_decimals(), format)) << name(format);
    EXPECT_TRUE(writes_exactly({}, format)) << name(format);
    EXPECT_EQ(writes_exactly(fractions(), format), format == MeshFormat::json) << name(format);
    // STL has triangles only, and neither points nor segments.
    const bool any = format != MeshFormat::stl;
    EXPECT_EQ(writes_exactly(cube(), format), any) << name(format);
    EXPECT_EQ(writes_exactly(operands()[1], format), any) << name(format);
    EXPECT_EQ(writes_exactly(operands()[2], format), any) << name(format);
  }
}

TEST(MeshWrite, FractionsInTextAreTheSameInEveryFormat) {
  const std::vector<std::string> p = {"1/3 0 0", "0 10/7 0", "22/7 0 1/9", "0 0 355/113"};
  std::string off = "OFF 4 4 0\n", obj, stl = "solid\n";
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
      "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  for (const std::string& vertex : p) {
    off += vertex + "\n";
    ply += vertex + "\n";
    obj += "v " + vertex + "\n";
  }
  for (const Face& face : tetrahedron().faces) {
    std::string zero_based = "3", one_based = "f";
    stl += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : face) {
      zero_based += " " + std::to_string(v);
      one_based += " " + std::to_string(v + 1);
      stl += "vertex " + p[v] + "\n";
    }
    stl += "endloop\nendfacet\n";
    off += zero_based + "\n";
    ply += zero_based + "\n";
    obj += one_based + "\n";
  }
  EXPECT_EQ(mesh_in(off, MeshFormat::off), fractions());
  EXPECT_EQ(mesh_in(obj, MeshFormat::obj), fractions());
  EXPECT_EQ(mesh_in(ply, MeshFormat::ply), fractions());
  EXPECT_EQ(mesh_in(stl + "endsolid\n", MeshFormat::stl), fractions());
}

TEST(MeshWrite, ACubeIsTheSameInEveryFormatSaveForItsTrianglesInStl) {
  for (const MeshFormat format : mesh_formats) {
    const Polyhedron read = mesh_in(write_mesh(cube(), format), format);
    EXPECT_EQ(read.vertices.size(), 8U);
    EXPECT_EQ(read.faces.size(), format == MeshFormat::stl ? 12U : 6U);
    EXPECT_EQ(sextuple_volume(read), 6);
  }
  EXPECT_EQ(mesh_in(binary_ply(cube(), std::endian::big, false), MeshFormat::ply), cube());
}

TEST(MeshWrite, RandomTetrahedraAreReadBackFromEveryExactFormat) {
  const unsigned seed = 20260302;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  int decimal_ones = 0;
  for (int round = 0; round < 300; ++round) {
    const auto number = [&] {
      return Rational(static_cast<int>(random() % 2001) - 1000,
                      static_cast<int>(random() % (round % 2 == 0 ? 2 : 40)) + 1);
    };
    const auto point = [&] { return SpacePoint{number(), number(), number()}; };
    Polyhedron shape = tetrahedron(point(), point(), point(), point());
    const Rational volume = sextuple_volume(shape);
    if (volume == 0) continue;
    if (volume < 0) std::swap(shape.vertices[0], shape.vertices[1]);
    for (const MeshFormat format : mesh_formats) {
      if (!writes_exactly(shape, format)) continue;
      decimal_ones += format == MeshFormat::stl ? 1 : 0;
      EXPECT_EQ(mesh_in(write_mesh(shape, format), format), shape);
    }
  }
  EXPECT_GT(decimal_ones, 100);
}

TEST(MeshWrite, TheWordsOfEachFormat) {
  const Polyhedron point{{space_point("1/2", "-1", "0.1")}, {}};
  EXPECT_EQ(write_mesh(point, MeshFormat::off), "OFF\n1 0 0\n0.5 -1 0.1\n");
  EXPECT_EQ(write_mesh(point, MeshFormat::obj), "v 0.5 -1 0.1\n");
  EXPECT_EQ(write_mesh(point, MeshFormat::json),
            "{\"faces\":[],\"vertices\":[[\"1/2\",\"-1\",\"1/10\"]]}\n");
  EXPECT_EQ(write_mesh({}, MeshFormat::obj), "# the empty set\n");
  EXPECT_EQ(write_mesh({}, MeshFormat::stl), "solid minkref\nendsolid minkref\n");
  const std::string ply = write_mesh(tetrahedron(), MeshFormat::ply);
  EXPECT_EQ(ply,
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
            "property double z\nelement face 4\nproperty list uchar uint vertex_indices\n"
            "end_header\n0 0 0\n0 1 0\n1 0 0\n0 0 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n");
  EXPECT_TRUE(write_mesh(tetrahedron(), MeshFormat::obj)
                  .ends_with("0 1\nf 1 2 3\nf 1 3 4\n"
                             "f 1 4 2\nf 2 4 3\n"));
  EXPECT_TRUE(write_mesh(tetrahedron(), MeshFormat::stl)
                  .starts_with("solid minkref\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n"
                               "vertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"));
}

TEST(MeshWrite, ThirdsAreRoundedToTheNearestDoubleAndSaidToBeInexact) {
  const Polyhedron point{{space_point("1/3", "-2/3", "1")}, {}};
  EXPECT_FALSE(writes_exactly(point, MeshFormat::off));
  EXPECT_EQ(write_mesh(point, MeshFormat::off),
            "OFF\n1 0 0\n0.33333333333333331 -0.66666666666666663 1\n");
}

TEST(MeshWrite, AFaceOfMoreThan255VerticesHasALongerLengthInPly) {
  // A prism over a convex polygon: the points (i, i^2).
  Polyhedron prism;
  const std::uint32_t n = 300;
  for (std::uint32_t k = 0; k < 2 * n; ++k) {
    prism.vertices.push_back({k % n, k % n * (k % n), k / n});
  }
  Face bottom, top;
  for (std::uint32_t k = 0; k < n; ++k) {
    bottom.push_back(n - 1 - k);
    top.push_back(n + k);
    const std::uint32_t next = (k + 1) % n;
    prism.faces.push_back({k, next, n + next, n + k});
  }
  prism.faces.push_back(bottom);
  prism.faces.push_back(top);
  for (const MeshFormat format : {MeshFormat::off, MeshFormat::obj, MeshFormat::ply}) {
    EXPECT_EQ(mesh_in(write_mesh(prism, format), format), prism) << name(format);
  }
  EXPECT_NE(write_mesh(prism, MeshFormat::ply).find("list uint uint"), std::string::npos);
  const Polyhedron cut = mesh_in(write_mesh(prism, MeshFormat::stl), MeshFormat::stl);
  EXPECT_EQ(sextuple_volume(cut), sextuple_volume(prism));
}

TEST(MeshWrite, WhatStlDoesNotHaveIsRefused) {
  for (const Polyhedron& polyhedron : {operands()[1], operands()[2]}) {
    EXPECT_EQ(refusal_of([&] { write_mesh(polyhedron, MeshFormat::stl); }).code(),
              "not-representable");
  }
  Polyhedron folded = cube();
  folded.faces[2] = {0, 1, 0, 1};
  const BadInput refused = refusal_of([&] { write_mesh(folded, MeshFormat::stl); });
  EXPECT_EQ(refused.code(), "not-representable");
  EXPECT_EQ(refused.place().face, 2U);
}

TEST(MeshWrite, StlMakesEqualVerticesOneAndIsThenNotExact) {
  Polyhedron two = tetrahedron();
  const Polyhedron other = tetrahedron(space_point("0", "0", "0"), space_point("0", "-1", "0"),
                                       space_point("-1", "0", "0"), space_point("0", "0", "-1"));
  for (const SpacePoint& vertex : other.vertices) two.vertices.push_back(vertex);
  for (const Face& face : other.faces) two.faces.push_back({face[0] + 4, face[2] + 4, face[1] + 4});
  EXPECT_NO_THROW(validate(two));
  EXPECT_FALSE(writes_exactly(two, MeshFormat::stl));
  EXPECT_TRUE(writes_exactly(two, MeshFormat::off));
  EXPECT_EQ(mesh_in(write_mesh(two, MeshFormat::off), MeshFormat::off), two);
  EXPECT_EQ(mesh_code(write_mesh(two, MeshFormat::stl), MeshFormat::stl), "non-manifold-vertex");
}

TEST(MeshWrite, ANumberBeyondDoublesWithoutADecimalIsRefused) {
  const Rational huge(pow(Integer(10), 400), 3);
  const Polyhedron far{{{huge, 0, 0}}, {}};
  EXPECT_EQ(refusal_of([&] { write_mesh(far, MeshFormat::ply); }).code(), "not-representable");
  EXPECT_EQ(mesh_in(write_mesh(far, MeshFormat::json), MeshFormat::json), far);
}

TEST(MeshFile, TheExtensionNamesTheFormat) {
  const TemporaryFolder folder;
  for (const MeshFormat format : mesh_formats) {
    const std::string path = folder.file("a." + name(format), write_mesh(tetrahedron(), format));
    EXPECT_EQ(read_valid_mesh_file(path).polyhedron, tetrahedron());
    EXPECT_EQ(mesh_format_of_file("B." + name(format)), format);
    EXPECT_EQ(mesh_format_named(name(format)), format);
  }
  EXPECT_EQ(mesh_format_of_file("A.OFF"), MeshFormat::off);
  const std::string binary = folder.file("b.stl", binary_stl(tetrahedron()));
  EXPECT_EQ(read_valid_mesh_file(binary).polyhedron, tetrahedron());
  EXPECT_EQ(refusal_of([] { mesh_format_named("wkt"); }).code(), "unknown-format");
  for (const char* path : {"a.wkt", "off", "a"}) {
    const BadInput refused = refusal_of([&] { read_mesh_file(folder.file(path, "x")); });
    EXPECT_EQ(refused.code(), "unknown-format");
    EXPECT_EQ(refused.place().source, folder.path(path));
  }
  EXPECT_EQ(refusal_of([&] { read_mesh_file(folder.path("missing.off")); }).code(), "cannot-read");
}

}  // namespace
}  // namespace minkref::of_mesh_write
