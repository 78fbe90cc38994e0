#include "core/pipeline/stage_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/scan_evidence.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

Scan ballScan() {
  Scan scan;
  auto volume = std::make_shared<Volume<float>>(
      test::speckledSphere(test::grid({44, 44, 30}, {0.3, 0.3, 0.5}), {6.6, 7.4, 7.5}, 4.5, 0.15));
  scan.key = scanKey(*volume, {});
  scan.volume = volume;
  return scan;
}

// Outcome: what a run made, as fingerprints, beside the keys that its parameters have.
struct Outcome {
  StageKeys keys;
  Key classified, points, evidence, face, pieces, mesh, print;
  std::string error;
};

Key of(const Mesh* mesh) {
  Hasher hasher("mesh");
  if (!mesh) return {};
  hasher.addBytes(mesh->positions.data(), mesh->positions.size() * sizeof(glm::vec3));
  hasher.addBytes(mesh->normals.data(), mesh->normals.size() * sizeof(glm::vec3));
  hasher.add(std::span<const float>(mesh->visibility)).add(std::span<const float>(mesh->measured));
  return hasher.addBytes(mesh->triangles.data(), mesh->triangles.size() * sizeof(Triangle)).key();
}

Key of(const FaceFit* face) {
  if (!face) return {};
  Hasher hasher("face");
  hasher.add(face->confidence).add(face->headHeight).add(face->score);
  return hasher.addBytes(&face->up, sizeof face->up).addBytes(&face->front, sizeof face->front).key();
}

Key of(const ScanEvidence& e) {
  Hasher hasher("evidence");
  hasher.add(e.hasEdges).add(e.noise).add(e.dark).add(e.sideways).add(e.clear).add(e.largest);
  return hasher.add(e.rise).add(e.width).key();
}

Outcome outcomeOf(const Scan& scan, const Parameters& parameters) {
  Outcome outcome;
  outcome.keys = stageKeys(scan.key, scan.erasedKey, parameters);
  try {
    Pipeline pipeline;  // one that remembers nothing
    const Results r = pipeline.run(scan, parameters, Goal::mesh);
    EXPECT_EQ(r.keys.print, outcome.keys.print);
    outcome.classified = Hasher("u").add(std::span<const float>(r.classified->data)).key();
    Hasher points("points");
    points.addBytes(r.points->positions.data(), r.points->positions.size() * sizeof(glm::vec3));
    outcome.points =
        points.addBytes(r.points->normals.data(), r.points->normals.size() * sizeof(glm::vec3)).key();
    outcome.evidence = of(*r.evidence);
    outcome.face = of(r.face.get());
    EXPECT_TRUE(r.isFinal) << "the stages make the same keys as stageKeys()";
    Hasher pieces("pieces");
    for (const Mesh& piece : *r.pieces) pieces.add(of(&piece));
    outcome.pieces = pieces.key();
    outcome.mesh = of(r.mesh.get());
    outcome.print = of(r.print.get());
  } catch (const Error& error) {
    outcome.error = error.what();
  }
  return outcome;
}

// Equal keys, equal results: of every stage.
void expectHonest(const Outcome& a, const Outcome& b, const std::string& what) {
  if (!(b.keys.print == a.keys.print) && !(b.error.empty() && a.error.empty())) return;
  EXPECT_EQ(a.error, b.error) << what;
  const auto check = [&](const Key& keyA, const Key& keyB, const Key& madeA, const Key& madeB,
                         const char* stage) {
    if (keyA == keyB) {
      EXPECT_EQ(madeA.hex(), madeB.hex()) << what << " changes " << stage << ", but not its key";
    }
  };
  check(a.keys.classified, b.keys.classified, a.classified, b.classified, "the classified volume");
  check(a.keys.points, b.keys.points, a.points, b.points, "the points");
  check(a.keys.evidence, b.keys.evidence, a.evidence, b.evidence, "the evidence");
  check(a.keys.face, b.keys.face, a.face, b.face, "the face");
  check(a.keys.pieces, b.keys.pieces, a.pieces, b.pieces, "the surface");
  check(a.keys.mesh, b.keys.mesh, a.mesh, b.mesh, "the mesh");
  check(a.keys.print, b.keys.print, a.print, b.print, "the solid");
}

// Changer: gives a parameter another legal value, and not one far away.
struct Changer {
  void operator()(bool& v) const { v = !v; }
  template <NamedEnum E>
  void operator()(E& v) const {
    v = E((int(v) + 1) % int(enumNames(E{}).size()));
  }
  template <class T>
  void operator()(T& v, const Range<T>& range) const {
    const T more = v == 0 ? T(range.min + (range.max - range.min) / 10) : T(double(v) * 1.3);
    v = more == v ? T(v + 1) : more;
    if (v > range.max) v = T(range.min + (range.max - range.min) / 2);
  }
  template <class T>
  void operator()(std::array<T, 3>& v, const Range<T>& range) const {
    (*this)(v[1], range);
  }
  void operator()(Places& v, const Range<double>&) const {
    for (int i = 0; i < 3; ++i) v.push_back({6.6, 3.0 + i, 7.5});
  }
};

// Changes every field of the groups in turn.
void walk(const Scan& scan, const Parameters& base, std::initializer_list<std::string_view> names) {
  const Outcome before = outcomeOf(scan, base);
  ASSERT_EQ(before.error, "");
  Parameters changed = base;
  forEachField(
      [&](const Group& group, const Field& field, auto& member, auto... range) {
        if (std::find(names.begin(), names.end(), group.name) == names.end()) return;
        const auto kept = member;
        Changer()(member, range...);
        const std::string what = std::string(group.name) + "." + std::string(field.name);
        EXPECT_FALSE(parametersKey(changed) == parametersKey(base)) << what;
        expectHonest(before, outcomeOf(scan, changed), what);
        member = kept;
      },
      changed);
}

Parameters small() {
  Parameters p;
  p.mesh.resolution = 40;
  return p;
}

TEST(StageKeys, EqualKeysMeanEqualResultsForEveryParameter) {
  walk(ballScan(), small(),
       {"scan", "classification", "enhancement", "region", "surface", "reconstruction", "global", "mesh",
        "print", "face"});
}

TEST(StageKeys, SoTheyDoForTheGlobalFunctionAndEnhancedVolumes) {
  Parameters p = small();
  p.reconstruction.method = ReconstructionMethod::global;
  p.enhancement.method = EnhancementMethod::diffusion;
  p.print.form = PrintForm::block;
  p.mesh.resolution = 24;
  walk(ballScan(), p, {"enhancement", "global", "print"});
}

TEST(StageKeys, SoTheyDoForTheThesisOwnWay) {
  Parameters p = small();
  p.classification.formulation = Formulation::thesisSkew;
  p.reconstruction.method = ReconstructionMethod::thesis;
  p.mesh.piece = PieceChoice::index;
  walk(ballScan(), p, {"classification", "surface", "reconstruction", "mesh", "face"});
}

TEST(StageKeys, PicturesAndSimulationReachNoStage) {
  const Scan scan = ballScan();
  const Parameters base = small();
  Parameters changed = base;
  forEachField(
      [&](const Group& group, const Field&, auto& member, auto... range) {
        if (group.name == "phantom" || group.name == "skin" || group.name == "light" ||
            group.name == "landmarks")
          Changer()(member, range...);
      },
      changed);
  EXPECT_EQ(stageKeys(scan.key, {}, base).print, stageKeys(scan.key, {}, changed).print);
  EXPECT_NE(parametersKey(base), parametersKey(changed));
  expectHonest(outcomeOf(scan, base), outcomeOf(scan, changed), "phantom, skin, light and landmarks");
}

TEST(StageKeys, WhatIsErasedReachesThePointsAlone) {
  const Key scan = Hasher("scan").key(), erased = Hasher("erased").key();
  const StageKeys whole = stageKeys(scan, {}, {}), cut = stageKeys(scan, erased, {});
  EXPECT_EQ(whole.classified, cut.classified);
  EXPECT_NE(whole.points, cut.points);
  EXPECT_NE(whole.mesh, cut.mesh);
}

// The method that is not chosen, and lists that the choice of pieces does not read, are no reason for another surface.
TEST(StageKeys, WhatIsNotUsedIsNotPartOfThem) {
  const Key scan = Hasher("scan").key();
  Parameters p;
  const StageKeys base = stageKeys(scan, {}, p);
  p.global.accuracy *= 2;
  EXPECT_EQ(stageKeys(scan, {}, p).mesh, base.mesh);
  p.reconstruction.method = ReconstructionMethod::global;
  const StageKeys global = stageKeys(scan, {}, p);
  EXPECT_NE(global.mesh, base.mesh);
  p.global.accuracy *= 2;
  EXPECT_NE(stageKeys(scan, {}, p).mesh, global.mesh);
}

TEST(StageKeys, ShortCutsHaveKeysOfTheirOwn) {
  const Parameters p;
  const StageKeys final = stageKeys(Hasher("scan").key(), {}, p);
  const Key live = classifiedKey(final.prepared, p.classification, true);
  EXPECT_NE(live, final.classified);
  EXPECT_NE(pointsKey(live, {}, p), final.points);
  EXPECT_EQ(keptKey(final.parts, final.face, p), final.kept);
  EXPECT_NE(keptKey(final.parts, {}, p), final.kept) << "chosen without a face";
}

}  // namespace
}  // namespace sonoskin
