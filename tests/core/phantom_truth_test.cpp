#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/phantom/phantom.h"
#include "core/phantom/scene_world.h"
#include "tests/support/first_phantom.h"

namespace sonoskin {
namespace {

PhantomOptions smallOptions() {
  PhantomOptions options;
  options.dims = {117, 64, 62};
  return options;
}

const Mesh& truth() {
  static const Mesh mesh = makePhantomTruth(smallOptions());
  return mesh;
}

// onCap: whether a vertex lies where the baby leaves the field of view.
bool onCap(const glm::vec3& p) {
  const glm::vec3 far = glm::vec3(kFieldOfView) - p;
  return std::min({p.x, p.y, p.z, far.x, far.y, far.z}) < 2e-3f;
}

TEST(PhantomTruth, IsAClosedSurface) {
  const MeshCheck check = checkMesh(truth());
  EXPECT_TRUE(check.closed());
  EXPECT_TRUE(check.manifold());
  EXPECT_TRUE(check.oriented());
  EXPECT_GT(enclosedVolume(truth()), 1.5e5);  // mm^3
}

TEST(PhantomTruth, LiesOnTheSkin) {
  int creases = 0;
  for (const glm::vec3& p : truth().positions)
    if (!onCap(p)) creases += std::abs(test::skinDistance(glm::dvec3(p))) > 0.02;
  EXPECT_LT(creases, int(truth().positions.size() / 500));
}

TEST(PhantomTruth, NormalsAgreeWithTheTriangles) {
  const Mesh& mesh = truth();
  std::size_t against = 0;
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    against += glm::dot(glm::cross(b - a, c - a), mesh.normals[t[0]]) < 0;
  }
  EXPECT_LT(against, mesh.triangles.size() / 200);
  for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1, 1e-4);
}

TEST(PhantomTruth, TheProbeSeesTheFaceAndNotTheBackOfTheHead) {
  const Mesh& mesh = truth();
  const glm::vec3 apex(70.05f, -45, 55.8f);
  std::size_t seen = 0;
  int nose = 0, mouth = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3& p = mesh.positions[v];
    ASSERT_TRUE(mesh.visibility[v] == 0 || mesh.visibility[v] == 1);
    if (mesh.visibility[v] == 0) continue;
    ++seen;
    ASSERT_FALSE(onCap(p));
    ASSERT_GT(glm::dot(mesh.normals[v], glm::normalize(apex - p)), 0.249f);
    nose += std::abs(p.x - 68) < 3 && std::abs(p.z - 50) < 3;
    mouth += std::abs(p.x - 81) < 4 && std::abs(p.z - 51) < 6;
  }
  EXPECT_GT(seen, mesh.positions.size() / 6);
  EXPECT_LT(seen, mesh.positions.size() / 2);
  EXPECT_GT(nose, 20);
  EXPECT_GT(mouth, 40) << "the hand must not hide the mouth";
}

// A straight look from every seen vertex back to the probe meets no skin.
TEST(PhantomTruth, NothingHidesWhatIsSeen) {
  const Mesh& mesh = truth();
  const glm::dvec3 apex(70.05, -45, 55.8);
  int seen = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); v += 37) {
    if (mesh.visibility[v] == 0) continue;
    ++seen;
    const glm::dvec3 p(mesh.positions[v]), back = glm::normalize(apex - p);
    for (double t = 1.5; (p + back * t).y > 0; t += std::max(0.3, 0.7 * test::skinDistance(p + back * t)))
      ASSERT_GT(test::skinDistance(p + back * t), -0.15) << p.x << ' ' << p.y << ' ' << p.z;
  }
  EXPECT_GT(seen, 100);
}

// share: of the truth's vertices within a box that carry a label.
double share(BodyPart part, const glm::vec3& low, const glm::vec3& high) {
  int inside = 0, with = 0;
  for (std::size_t v = 0; v < truth().positions.size(); ++v) {
    const glm::vec3& p = truth().positions[v];
    if (!glm::all(glm::lessThan(low, p)) || !glm::all(glm::lessThan(p, high))) continue;
    ++inside, with += truth().labels[v] == std::uint8_t(part);
  }
  EXPECT_GT(inside, 20);
  return with / std::max(1., double(inside));
}

TEST(PhantomTruth, LabelsTheParts) {
  ASSERT_EQ(truth().labels.size(), truth().positions.size());
  const FacePlaces f = test::firstPhantom().facePlaces();
  for (const glm::dvec3& p : {f.rightEye, f.leftEye, f.noseTip, f.mouthRight})
    EXPECT_EQ(share(BodyPart::face, glm::vec3(p) - 4.f, glm::vec3(p) + 4.f), 1);
  EXPECT_EQ(share(BodyPart::head, {0, 50, 30}, {18, 76.4f, 80}), 1) << "crown";
  EXPECT_EQ(share(BodyPart::head, {40, 50, 92}, {70, 76.4f, 105}), 1) << "ear";
  EXPECT_EQ(share(BodyPart::hand, {82, 20, 64}, {92, 31, 90}), 1) << "fingers";
  EXPECT_EQ(share(BodyPart::body, {125, 60, 5}, {140, 76.4f, 80}), 1) << "chest";
  int face = 0;
  for (const std::uint8_t label : truth().labels) face += label == std::uint8_t(BodyPart::face);
  EXPECT_GT(face, int(truth().labels.size() / 10));
}

TEST(PhantomTruth, IsTheSameOnAnyNumberOfThreads) {
  setThreadCount(1);
  const Mesh one = makePhantomTruth(smallOptions());
  setThreadCount(0);
  EXPECT_EQ(one.positions, truth().positions);
  EXPECT_EQ(one.visibility, truth().visibility);
}

TEST(PhantomTruth, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(makePhantomTruth(smallOptions(), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
