#include "app/document/parameter_text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"

namespace sonoskin {
namespace {

TEST(ParameterText, ReadsEveryKindOfValue) {
  Parameters p;
  setParameter(p, "classification.alpha", "0.7");
  setParameter(p, "phantom.seed", "12");
  setParameter(p, "phantom.dims", "64x48x32");
  setParameter(p, "mesh.piece", "largest");
  setParameter(p, "mesh.piecePoint", "-1.5,2,1e3");
  setParameter(p, "mesh.partsDrop", "1,2,3;-4,5e1,0.5");
  setParameter(p, "mesh.partsAdd", "7,8,9");
  setParameter(p, "reconstruction.fitWeights", "on");
  EXPECT_EQ(p.classification.alpha, 0.7);
  EXPECT_EQ(p.phantom.seed, 12);
  EXPECT_EQ(p.phantom.dims, (std::array<int, 3>{64, 48, 32}));
  EXPECT_EQ(p.mesh.piece, PieceChoice::largest);
  EXPECT_EQ(p.mesh.piecePoint, (std::array<double, 3>{-1.5, 2, 1000}));
  EXPECT_EQ(p.mesh.partsDrop, (Places{{1, 2, 3}, {-4, 50, 0.5}}));
  EXPECT_EQ(p.mesh.partsAdd, (Places{{7, 8, 9}}));
  setParameter(p, "mesh.partsAdd", "none");
  EXPECT_TRUE(p.mesh.partsAdd.empty());
  EXPECT_TRUE(p.reconstruction.fitWeights);
}

TEST(ParameterText, MessagesShowNoMoreThanALineOfWhatWasGiven) {
  Parameters p;
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"scan.apex", "1,2,\x1b[2J\n"},
                                   {"classification.alpha", std::string(100'000, '9')},
                                   {"\x1b]0;a\a" + std::string(100'000, 'x'), "1"}})
    try {
      setParameter(p, name, text);
      ADD_FAILURE() << name << " took " << text;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_LT(message.size(), 300u);
      EXPECT_TRUE(std::ranges::none_of(message, [](unsigned char c) { return c < 0x20; })) << message;
    }
}

TEST(ParameterText, RefusesWhatIsNotAValueAndChangesNothing) {
  Parameters p;
  const auto refuses = [&](const char* name, const char* text) {
    try {
      setParameter(p, name, text);
      ADD_FAILURE() << name << " took " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::usage);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  };
  for (const char* text : {"", "x", "1x", " 1", "inf", "nan", "99", "-1", "0"})
    refuses("classification.alpha", text);
  for (const char* text : {"1.5", "", "-1", "99999999999999"}) refuses("phantom.seed", text);
  for (const char* text : {"64", "64x48", "64x48x", "64x48x32x16", "64,48,32", "64x48x2"})
    refuses("phantom.dims", text);
  for (const char* text : {"maybe", "", "yes"}) refuses("reconstruction.fitWeights", text);
  for (const char* text : {"", "1,2", "1,2,3;", ";1,2,3", "1,2,3;4,5", "1,2,3 4,5,6", "1,2,1e6"})
    refuses("mesh.partsDrop", text);
  refuses("mesh.piece", "smallest");
  refuses("mesh.no-such", "1");
  EXPECT_EQ(p.classification.alpha, Parameters{}.classification.alpha);
  EXPECT_EQ(p.phantom.dims, Parameters{}.phantom.dims);
}

TEST(ParameterText, EveryValueReadsBackToItself) {
  Parameters changed;
  changed.classification.alpha = 0.1 + 0.2;  // not the number that prints as 0.3
  changed.mesh.piecePoint = {1.0 / 3, -2e-7, 5};
  changed.mesh.piece = PieceChoice::point;
  changed.mesh.partsCut = {{1, 2, 3}, {1.0 / 7, 0, -2e-7}, {0, 0, 1}};
  Parameters copy;
  for (const ParameterInfo& info : describeParameters(changed)) setParameter(copy, info.name, info.value);
  EXPECT_EQ(copy.classification.alpha, changed.classification.alpha);
  EXPECT_EQ(copy.mesh.piecePoint, changed.mesh.piecePoint);
  EXPECT_EQ(copy.mesh.piece, changed.mesh.piece);
  EXPECT_EQ(copy.mesh.partsCut, changed.mesh.partsCut);
}

TEST(ParameterText, DescribesEveryParameterFully) {
  for (const ParameterInfo& info : describeParameters({})) {
    EXPECT_FALSE(info.help.empty()) << info.name;
    EXPECT_FALSE(info.value.empty()) << info.name;
    EXPECT_FALSE(info.help.ends_with('.') && !info.help.ends_with("...")) << info.name;
    const bool isNumber = info.kind == "NUMBER" || info.kind == "INTEGER" || info.kind == "NxNxN" ||
                          info.kind == "X,Y,Z" || info.kind == "X,Y,Z;...";
    EXPECT_EQ(info.range.empty(), !isNumber) << info.name;
  }
}

}  // namespace
}  // namespace sonoskin
