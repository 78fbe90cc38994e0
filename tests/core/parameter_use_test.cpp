#include "core/pipeline/parameter_use.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/parallel.h"
#include "core/classification/classify.h"
#include "core/rbf/compact/csrbf_model.h"
#include "tests/support/synthetic_points.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// Other values of a parameter, inside its range.
struct Changed {
  bool operator()(bool& value) const { return value = !value, true; }
  bool operator()(double& value, Range<double> range) const {
    value = 0.3 * range.min + 0.7 * range.max == value ? range.max : 0.3 * range.min + 0.7 * range.max;
    return true;
  }
  template <NamedEnum E>
  bool operator()(E& value) const {
    return value = E((int(value) + 1) % int(enumNames(E{}).size())), true;
  }
};

LargeArray<float> classified(const Volume<float>& v, const ClassificationOptions& o) {
  return classify(v, smooth(v, o), o).data;
}

// Whether moving the named parameter alone changes the classified volume.
bool matters(const Volume<float>& v, const ClassificationOptions& options, std::string_view name) {
  ClassificationOptions other = options;
  fields(
      [&](const Field& field, auto& member, auto... range) {
        if (field.name == name) Changed{}(member, range...);
      },
      other);
  return classified(v, options) != classified(v, other);
}

// What is called unused changes nothing, and what is not called so changes something: parameter by parameter.
TEST(ParameterUse, AgreesWithTheClassification) {
  setThreadCount(1);  // a team of threads costs more than this volume
  const auto v = test::speckledSphere(test::grid({14, 13, 12}, {1, 1, 2}), {6, 6, 11}, 5, 0.5);
  for (const Formulation f : {Formulation::variational, Formulation::thesisClosed, Formulation::thesisSkew}) {
    Parameters p;
    p.classification.formulation = f;
    p.classification.isoValue = 0.4;
    p.classification.farthest = 2;
    p.classification.beta = 2;
    p.classification.tolerance = 1e-4;
    ClassificationOptions& o = p.classification;
    fields(
        [&](const Field& field, auto&, auto...) {
          // The low-pass shapes normals and thinning too, whatever the formulation.
          if (field.name == "lowPass" || field.name == "formulation") return;
          const bool used = unusedBecause(p, "classification", field.name).empty();
          EXPECT_EQ(matters(v, o, field.name), used) << field.name << " with formulation " << int(f);
        },
        o);
  }
  setThreadCount(0);
}

TEST(ParameterUse, WithoutSmoothingItsOtherParametersAreUnused) {
  Parameters p;
  EXPECT_TRUE(unusedBecause(p, "classification", "tangentialLength").empty());
  p.classification.beta = 0;
  EXPECT_FALSE(unusedBecause(p, "classification", "tangentialLength").empty());
  EXPECT_TRUE(unusedBecause(p, "classification", "beta").empty());
  p.classification.beta = 1;
  p.classification.tangentialLength = 0;
  EXPECT_FALSE(unusedBecause(p, "classification", "beta").empty());
  EXPECT_TRUE(unusedBecause(p, "classification", "tangentialLength").empty());
}

TEST(ParameterUse, WithoutEnhancementItsParametersAreUnused) {
  Parameters p;
  EXPECT_FALSE(unusedBecause(p, "enhancement", "iterations").empty());
  EXPECT_TRUE(unusedBecause(p, "enhancement", "method").empty());
  p.enhancement.method = EnhancementMethod::diffusion;
  EXPECT_TRUE(unusedBecause(p, "enhancement", "iterations").empty());
}

// What a fit is said to ignore changes nothing, and everything else changes it.
TEST(ParameterUse, AFitIgnoresWhatItIsSaidToIgnore) {
  SurfacePoints points = spherePoints(5000, 10, 0.1);
  for (std::size_t i = 0; i < points.size(); i += 2) points.confidence[i] = 0.3f;
  points.noise.assign(points.size(), 0.02f);
  const auto outcome = [&](const ReconstructionOptions& o) {
    const CsrbfModel model = fitCsrbf(points, o);
    double sum = 0;
    for (const Centre& c : model.centres()) sum += double(c.support + c.quadric.f + c.lambda);
    return sum;
  };
  for (const auto method : {ReconstructionMethod::adaptive, ReconstructionMethod::thesis})
    for (const bool weights : {false, true}) {
      Parameters p;
      ReconstructionOptions& o = p.reconstruction;
      o = {.method = method, .smoothness = 1e-4, .maxSupport = 0.3, .fitWeights = weights};
      const double usual = outcome(o);
      const auto check = [&](const char* field, auto ReconstructionOptions::*member, auto value) {
        ReconstructionOptions changed = o;
        changed.*member = value;
        EXPECT_EQ(outcome(changed) != usual, unusedBecause(p, "reconstruction", field).empty())
            << field << " with method " << int(method) << " and weights " << weights;
      };
      check("smoothness", &ReconstructionOptions::smoothness, 5e-5);
      check("measuredNoise", &ReconstructionOptions::measuredNoise, false);
      check("overlap", &ReconstructionOptions::overlap, 2.0);
      check("neighbours", &ReconstructionOptions::neighbours, 20);
      check("maxSupport", &ReconstructionOptions::maxSupport, 0.05);
      check("confidence", &ReconstructionOptions::confidence, false);
      check("fitWeights", &ReconstructionOptions::fitWeights, !weights);
      check("regularisation", &ReconstructionOptions::regularisation, 1e-2);
    }
}

TEST(ParameterUse, TheLargestPieceNeedsNoStrength) {
  Parameters p;
  EXPECT_TRUE(unusedBecause(p, "surface", "strongShare").empty());
  p.surface.clusters = ClusterRule::largest;
  EXPECT_FALSE(unusedBecause(p, "surface", "strongShare").empty());
  EXPECT_TRUE(unusedBecause(p, "mesh", "strongShare").empty());
}

TEST(ParameterUse, EachChoiceOfThePieceHasItsOwnParameter) {
  Parameters p;
  const auto isUsed = [&](std::string_view field) { return unusedBecause(p, "mesh", field).empty(); };
  EXPECT_TRUE(isUsed("companions") && !isUsed("pieceIndex") && !isUsed("piecePoint"));
  p.mesh.piece = PieceChoice::index;
  EXPECT_TRUE(!isUsed("companions") && isUsed("pieceIndex") && !isUsed("piecePoint"));
  p.mesh.piece = PieceChoice::point;
  EXPECT_TRUE(!isUsed("companions") && !isUsed("pieceIndex") && isUsed("piecePoint"));
  p.mesh.piece = PieceChoice::all;
  EXPECT_TRUE(!isUsed("companions") && !isUsed("pieceIndex") && !isUsed("piecePoint"));
}

TEST(ParameterUse, ACellInMillimetresReplacesTheResolution) {
  Parameters p;
  EXPECT_TRUE(unusedBecause(p, "mesh", "resolution").empty());
  p.mesh.cell = 0.3;
  EXPECT_FALSE(unusedBecause(p, "mesh", "resolution").empty());
}

TEST(ParameterUse, PrintingNeedsAForm) {
  Parameters p;
  EXPECT_FALSE(unusedBecause(p, "print", "thickness").empty());
  EXPECT_TRUE(unusedBecause(p, "print", "form").empty());
  p.print.form = PrintForm::block;
  EXPECT_TRUE(unusedBecause(p, "print", "thickness").empty());
}

TEST(ParameterUse, EachMethodOfReconstructionHasItsOwnParameters) {
  Parameters p;
  EXPECT_TRUE(unusedBecause(p, "reconstruction", "smoothness").empty());
  EXPECT_FALSE(unusedBecause(p, "global", "accuracy").empty());
  EXPECT_TRUE(unusedBecause(p, "mesh", "support").empty());
  p.reconstruction.method = ReconstructionMethod::global;
  EXPECT_FALSE(unusedBecause(p, "reconstruction", "smoothness").empty());
  EXPECT_TRUE(unusedBecause(p, "reconstruction", "method").empty());
  EXPECT_TRUE(unusedBecause(p, "global", "accuracy").empty());
  EXPECT_FALSE(unusedBecause(p, "mesh", "support").empty());
  EXPECT_TRUE(unusedBecause(p, "mesh", "maxGap").empty());
}

TEST(ParameterUse, OnlySomeBasesHaveAWidth) {
  Parameters p;
  p.reconstruction.method = ReconstructionMethod::global;
  for (const GlobalBasis b : {GlobalBasis::biharmonic, GlobalBasis::triharmonic, GlobalBasis::thinPlate}) {
    p.global.basis = b;
    EXPECT_FALSE(unusedBecause(p, "global", "width").empty());
  }
  for (const GlobalBasis b : {GlobalBasis::gaussian, GlobalBasis::multiquadric,
                              GlobalBasis::inverseMultiquadric, GlobalBasis::wendland}) {
    p.global.basis = b;
    EXPECT_TRUE(unusedBecause(p, "global", "width").empty());
  }
}

bool used(const Parameters& p, const char* group, const char* field) {
  return unusedBecause(p, group, field).empty();
}

TEST(ParameterUse, PigmentsCountOnlyForTheirColour) {
  Parameters p;
  for (const char* field : {"melanin", "blood", "oxygen", "epidermis", "flush", "mottling"}) {
    p.skin.colour = SkinColour::pigments;
    EXPECT_TRUE(used(p, "skin", field)) << field;
    p.skin.colour = SkinColour::clay;
    EXPECT_FALSE(used(p, "skin", field)) << field;
  }
  EXPECT_FALSE(used(p, "landmarks", "leftEye"));
  EXPECT_TRUE(used(p, "skin", "vernix"));
}

TEST(ParameterUse, ACustomProfileHasOpticsOfItsOwn) {
  Parameters p;
  for (const char* field : {"absorption", "scattering", "gaussians"}) {
    p.skin.profile = ScatterProfile::newborn;
    EXPECT_FALSE(used(p, "skin", field)) << field;
    p.skin.profile = ScatterProfile::custom;
    EXPECT_TRUE(used(p, "skin", field)) << field;
  }
  EXPECT_TRUE(used(p, "skin", "mix"));
  p.skin.width = 0;
  EXPECT_FALSE(used(p, "skin", "mix"));
  EXPECT_TRUE(used(p, "skin", "roughness"));
  p.skin.gloss = 0;
  EXPECT_FALSE(used(p, "skin", "roughness"));
  p.skin.translucency = 0;
  EXPECT_FALSE(used(p, "skin", "thinModel"));
}

TEST(ParameterUse, OnlyALampHasADistanceAndOnlyOneInsidePassesTissue) {
  Parameters p;
  EXPECT_FALSE(used(p, "light", "distance"));
  EXPECT_FALSE(used(p, "skin", "density"));
  p.light.kind = LightKind::near;
  EXPECT_TRUE(used(p, "light", "distance"));
  EXPECT_FALSE(used(p, "skin", "density"));
  p.light.kind = LightKind::inside;
  EXPECT_TRUE(used(p, "skin", "density"));
  EXPECT_TRUE(used(p, "light", "azimuth"));
  p.light.distance = 0;
  EXPECT_FALSE(used(p, "light", "azimuth"));
  EXPECT_TRUE(used(p, "light", "softness"));
  p.light.shadows = false;
  EXPECT_FALSE(used(p, "light", "softness"));
}

TEST(ParameterUse, LipsNeedBothCornersOfTheMouth) {
  Parameters p;
  EXPECT_TRUE(used(p, "landmarks", "mouthLeft")) << "an unset one can be set";
  p.landmarks.mouthLeft = {1, 2, 3};
  EXPECT_FALSE(used(p, "landmarks", "mouthLeft"));
  EXPECT_TRUE(used(p, "landmarks", "mouthRight"));
  p.landmarks.mouthRight = {1, 5, 3};
  EXPECT_TRUE(used(p, "landmarks", "mouthLeft"));
  p.skin.flush = 0;
  EXPECT_TRUE(used(p, "landmarks", "mouthLeft")) << "lips are wet still";
  p.skin.wetness = 0;
  EXPECT_FALSE(used(p, "landmarks", "mouthLeft"));
}

TEST(ParameterUse, LidsAndNoseNeedBothEyes) {
  Parameters p;
  p.landmarks.noseTip = {1, 2, 3};
  p.landmarks.leftEye = {1, 2, 9};
  EXPECT_FALSE(used(p, "landmarks", "noseTip"));
  EXPECT_FALSE(used(p, "landmarks", "leftEye"));
  p.landmarks.rightEye = {1, 2, -9};
  EXPECT_TRUE(used(p, "landmarks", "noseTip"));
  EXPECT_TRUE(used(p, "landmarks", "leftEye"));
}

}  // namespace
}  // namespace sonoskin
