#include "core/pipeline/recipe.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "core/pipeline/check_ranges.h"
#include "core/pipeline/parameter_key.h"

namespace sonoskin {
namespace {

std::string complaint(const std::string& json) {
  Parameters parameters;
  try {
    readRecipe(json, parameters);
  } catch (const Error& e) {
    EXPECT_EQ(writeRecipe(parameters), writeRecipe(Parameters{})) << "a refused recipe changed something";
    return e.what();
  }
  return "";
}

TEST(Recipe, RoundTripIsIdentical) {
  Parameters parameters;
  parameters.classification.alpha = 0.7000000000000001;
  parameters.phantom.dims = {33, 44, 55};
  parameters.mesh.piece = PieceChoice::point;
  parameters.mesh.piecePoint = {1.5, -2.25, 1e-3};
  parameters.reconstruction.fitWeights = true;
  parameters.mesh.partsDrop = {{1, 2.5, -3}, {0, 0, 1e-3}};
  const std::string json = writeRecipe(parameters);
  Parameters read;
  readRecipe(json, read);
  EXPECT_EQ(writeRecipe(read), json);
  EXPECT_EQ(read.mesh.piece, PieceChoice::point);
  EXPECT_EQ(read.classification.alpha, 0.7000000000000001);
  EXPECT_EQ(read.mesh.partsDrop, parameters.mesh.partsDrop);
}

TEST(Recipe, ReadsListsOfPlaces) {
  Parameters parameters;
  readRecipe(R"({"mesh": {"partsAdd": [[1, 2, 3]], "partsDrop": []}})", parameters);
  EXPECT_EQ(parameters.mesh.partsAdd, (Places{{1, 2, 3}}));
  readRecipe(R"({"mesh": {"partsAdd": [[4, 5, 6], [7, 8, 9]]}})", parameters);
  EXPECT_EQ(parameters.mesh.partsAdd, (Places{{4, 5, 6}, {7, 8, 9}}));  // a list replaces the one before
  for (const char* json :
       {R"({"mesh": {"partsAdd": 1}})", R"({"mesh": {"partsAdd": [1, 2, 3]}})",
        R"({"mesh": {"partsAdd": [[1, 2]]}})", R"({"mesh": {"partsAdd": [[1, 2, "3"]]}})",
        R"({"mesh": {"partsAdd": [[1, 2, 1e9]]}})", R"({"mesh": {"partsCut": [[1, 2, 3]]}})"})
    EXPECT_NE(complaint(json), "") << json;
}

TEST(Recipe, HoldsEveryField) {
  const auto json = nlohmann::json::parse(writeRecipe(Parameters{}));
  Parameters parameters;
  int count = 0;
  forEachField(
      [&](const Group& g, const Field& f, auto&&...) {
        ++count;
        EXPECT_TRUE(json.at(std::string(g.name)).contains(std::string(f.name))) << g.name << "." << f.name;
      },
      parameters);
  EXPECT_GT(count, 30);
}

TEST(Recipe, PartialOneLeavesTheRest) {
  Parameters parameters;
  parameters.classification.gamma = 2;
  readRecipe(R"({"classification": {"alpha": 0.5}})", parameters);
  EXPECT_EQ(parameters.classification.alpha, 0.5);
  EXPECT_EQ(parameters.classification.gamma, 2);
}

TEST(Recipe, RefusesWhatItDoesNotKnowByName) {
  EXPECT_NE(complaint("{"), "");
  EXPECT_NE(complaint("[1, 2]"), "");
  EXPECT_NE(complaint(R"({"colour": {}})").find("\"colour\""), std::string::npos);
  EXPECT_NE(complaint(R"({"mesh": {"sides": 3}})").find("mesh.sides"), std::string::npos);
  EXPECT_NE(complaint(R"({"mesh": {"resolution": 1.5}})").find("a whole number"), std::string::npos);
  EXPECT_NE(complaint(R"({"mesh": {"piece": "biggest"}})").find("\"probe\", \"largest\""), std::string::npos);
  EXPECT_NE(complaint(R"({"mesh": {"piecePoint": [1, 2]}})").find("three numbers"), std::string::npos);
  EXPECT_NE(complaint(R"({"classification": {"alpha": 99}})").find("between 0.01 and 4"), std::string::npos);
  EXPECT_NE(complaint(R"({"reconstruction": {"fitWeights": 1}})").find("true or false"), std::string::npos);
}

TEST(Recipe, HoldsWhatWasErasedOfItsInput) {
  Geometry g;
  g.dims = {7, 5, 3};
  Volume<std::uint8_t> mask(g);
  for (const int v : {3, 4, 5, 50, 104}) mask.data[std::size_t(v)] = 1;
  const Key key = Hasher("scan").key();
  const std::string text = writeRecipe({}, key, &mask);
  Parameters parameters;
  const RecipeInput input = readRecipe(text, parameters);
  EXPECT_EQ(input.key, key.hex());
  EXPECT_EQ(fromRunLengths(input.erased, g).data, mask.data);
  EXPECT_NE(text.find("\"erased\": {\"dims\":[7,5,3],\"counts\":[3,3,"), std::string::npos) << text;
  EXPECT_TRUE(readRecipe(writeRecipe({}), parameters).erased.counts.empty());
}

TEST(Recipe, RefusesErasedPartsThatAreNone) {
  for (const char* erased :
       {"3", "{}", R"({"dims": [1, 2, 3]})", R"({"dims": [1, 2], "counts": []})",
        R"({"dims": [1, 2, 3], "counts": [-1]})", R"({"dims": [1, 2, 3], "counts": [1.5]})",
        R"({"dims": [1, 2, 3], "counts": {"a": 1}})"})
    EXPECT_NE(complaint(fmt::format(R"({{"erased": {}}})", erased)).find("erased"), std::string::npos)
        << erased;
}

TEST(Recipe, IsNotWrittenWithMoreRunsThanIsRead) {
  Geometry g;
  g.dims = {128, 128, 128};
  Volume<std::uint8_t> noise(g);
  for (std::size_t v = 0; v < noise.data.size(); ++v) noise.data[v] = v % 2;
  EXPECT_THROW(writeRecipe({}, {}, &noise), Error);
}

// Whatever a file holds: one short line, no wrapped number, nothing that a terminal would obey.
TEST(Recipe, RefusesWhatJsonAllowsAndWeDoNot) {
  EXPECT_NE(complaint(R"({"mesh": {"minArea": 1e999}})").find("too large"), std::string::npos);
  EXPECT_NE(complaint("8.85101009e345649").find("too large"), std::string::npos);
  for (const char* number : {"4294967297", "-4294967297", "99999999999999999999", "1e3", "2147483648"})
    EXPECT_NE(complaint(fmt::format(R"({{"mesh": {{"pieceIndex": {}}}}})", number)).find("whole number"),
              std::string::npos)
        << number;
  EXPECT_LT(complaint("{\"" + std::string(2'000'000, 'a') + "\": 1}").size(), 200u);
  EXPECT_EQ(complaint("{\"a\\u001b[31m\": 1}").find('\x1b'), std::string::npos);
  EXPECT_NE(complaint(std::string(100'000, '[')), "");
}

TEST(CheckRanges, RefusesNotANumber) {
  Parameters parameters;
  parameters.classification.beta = std::nan("");
  EXPECT_THROW(checkRanges(parameters), Error);
}

TEST(Fields, NamesAreUniqueAndDocumented) {
  std::set<std::string> names;
  Parameters parameters;
  forEachField(
      [&](const Group& g, const Field& f, auto&&...) {
        EXPECT_TRUE(names.insert(std::string(g.name) + "." + std::string(f.name)).second) << f.name;
        EXPECT_GT(f.help.size(), 10u) << f.name;
      },
      parameters);
}

TEST(ParameterKey, EveryFieldChangesIt) {
  Parameters original;
  const auto keys = [](const Parameters& p) {
    Hasher hasher("test");
    groups([&](const Group&, const auto& options) { addOptions(hasher, options); }, p);
    return hasher.key();
  };
  const Key before = keys(original);
  Parameters changed;
  forEachField(
      [&](const Group&, const Field& f, auto& member, auto...) {
        using T = std::decay_t<decltype(member)>;
        const T kept = member;
        if constexpr (std::is_same_v<T, bool>) {
          member = !member;
        } else if constexpr (std::is_enum_v<T>) {
          member = T(int(member) + 1);
        } else if constexpr (std::is_arithmetic_v<T>) {
          member = T(member + T(1));
        } else if constexpr (std::is_same_v<T, Places>) {
          member.push_back({1, 2, 3});
        } else {
          member[2] += 1;
        }
        EXPECT_NE(keys(changed), before) << f.name;
        member = kept;
        EXPECT_EQ(keys(changed), before) << f.name;
      },
      changed);
}

}  // namespace
}  // namespace sonoskin
