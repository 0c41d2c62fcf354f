// The paper's own models, where MINKREF_MODELS names their folder.
#include <cstdlib>

#include "formats/write.hpp"
#include "tests/formats/refusal.hpp"

namespace minkref::of_paper_models {
namespace {

struct Model {
  const char* file;
  std::size_t vertices, holes, warnings;
};

class PaperModel : public testing::TestWithParam<Model> {};

TEST_P(PaperModel, IsValidWithThePapersSizesAndSurvivesEveryFormat) {
  const char* folder = std::getenv("MINKREF_MODELS");
  if (folder == nullptr) GTEST_SKIP() << "MINKREF_MODELS not set";
  const Reading reading = read_valid_file(std::string(folder) + "/" + GetParam().file);
  ASSERT_EQ(reading.set.polygons.size(), 1U);
  EXPECT_EQ(reading.set.vertices(), GetParam().vertices);
  EXPECT_EQ(reading.set.polygons[0].holes.size(), GetParam().holes);
  EXPECT_EQ(reading.warnings.size(), GetParam().warnings);
  for (const Format format : {Format::wkt, Format::geojson, Format::poly, Format::json}) {
    EXPECT_EQ(read_text(write(reading.set, format), format, "").set, reading.set) << name(format);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, PaperModel,
                         testing::Values(Model{"bird.poly", 275, 0, 5},
                                         Model{"nazca_monkey.poly", 1204, 0, 0},
                                         Model{"neuron.poly", 1815, 18, 0}));

}  // namespace
}  // namespace minkref::of_paper_models
