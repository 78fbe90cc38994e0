// Small files in many dialects, made by tests/tools/make_volume_files.py, against what that script says of each.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"
#include "core/io/volume_loader.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kFolder = fs::path(SONOSKIN_TEST_DATA) / "volumes";

std::vector<Json> truths() {
  std::ifstream file(kFolder / "truth.json");
  return Json::parse(file);
}

glm::dvec3 vectorOf(const Json& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

double numberAt(const LoadedVolume& volume, std::size_t n) {
  const std::size_t size = numberTypeBytes(volume.stored.type);
  const std::uint8_t* at = volume.numbers.data() + n * size;
  const auto as = [&](auto number) {
    std::memcpy(&number, at, sizeof number);
    return double(number);
  };
  switch (volume.stored.type) {
    case NumberType::uint8:
      return *at;
    case NumberType::int16:
      return as(std::int16_t{});
    case NumberType::float32:
      return as(float{});
    default:
      return as(double{});
  }
}

// Every voxel of a step: 1 + i + 5 j + 20 k + 60 step, the same in each colour, after slope and intercept.
void expectNumbers(const LoadedVolume& volume, const Json& truth, int step) {
  const std::size_t colours = std::size_t(volume.stored.components);
  const double slope = truth["scale"][0], intercept = truth["scale"][1];
  for (std::size_t v = 0; v < 60; ++v)
    for (std::size_t c = 0; c < colours; ++c)
      ASSERT_NEAR(numberAt(volume, v * colours + c),
                  slope * double(1 + v + 60 * std::size_t(step)) + intercept, 1e-3)
          << "voxel " << v;
}

void expectPlace(const StoredVolume& stored, const Json& truth) {
  const Geometry& g = stored.geometry;
  EXPECT_EQ(g.dims, glm::ivec3(vectorOf(truth["dims"])));
  EXPECT_LT(glm::distance(g.origin, vectorOf(truth["origin"])), 1e-5);
  EXPECT_LT(glm::distance(g.spacing, vectorOf(truth["spacing"])), 1e-5);
  for (int a = 0; a < 3; ++a)
    EXPECT_LT(glm::distance(g.direction[a], vectorOf(truth["direction"][std::size_t(a)])), 1e-5)
        << "axis " << a;
  EXPECT_EQ(stored.spacingKnown, truth["known"].get<bool>());
  EXPECT_EQ(stored.timeSteps, truth["steps"].get<int>());
  EXPECT_NEAR(stored.stepSeconds, truth["seconds"].get<double>(), 1e-7);
  EXPECT_EQ(stored.components, truth["components"].get<int>());
}

TEST(VolumeFiles, EveryDialectSaysWhereItsVoxelsLie) {
  const std::vector<Json> all = truths();
  EXPECT_GT(all.size(), 100u);
  for (const Json& truth : all) {
    const std::string name = truth["file"];
    SCOPED_TRACE(name);
    LogRecord said;
    setLogListener([](LogLevel, const std::string&) {});
    try {
      for (int step = 0; step < truth["steps"].get<int>(); ++step) {
        const LoadedVolume volume = loadVolume(kFolder / name, ReadOptions{0, step + 1});
        expectPlace(volume.stored, truth);
        expectNumbers(volume, truth, step);
      }
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
    setLogListener({});
    const auto warnings = said.sentences(LogLevel::warning);
    EXPECT_EQ(!warnings.empty(), truth["warned"].get<bool>()) << (warnings.empty() ? "" : warnings[0]);
  }
}

}  // namespace
}  // namespace sonoskin
