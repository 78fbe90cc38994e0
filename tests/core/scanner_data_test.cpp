// Files of scanners, as far as there are any on this machine: simulated ones with an exact surface, and real samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/log.h"
#include "core/io/mesh_reader.h"
#include "core/io/volume_reader.h"
#include "core/mesh/search/mesh_distance.h"
#include "core/pipeline/pipeline.h"
#include "core/volume/mirror_scan.h"
#include "core/volume/sample.h"
#include "tests/support/expect_error.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::expectError;

const fs::path kData = SONOSKIN_SHARED_DATA;
#define NEEDS(file) \
  if (!fs::exists(kData / (file))) GTEST_SKIP() << "no " << (file) << " on this machine"

// The mean grey of 0 to 255 at some mm along the normals of the vertices that face the probe.
double greyAlongNormals(const Scan& scan, const Mesh& mesh, float mm) {
  double sum = 0;
  int count = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!(mesh.normals[v].z < -0.6f)) continue;
    const glm::vec3 at = mesh.positions[v] + mm * mesh.normals[v];
    sum +=
        255 * double(sampleTrilinear(*scan.volume, glm::vec3(scan.volume->geometry.toIndex(glm::dvec3(at)))));
    ++count;
  }
  return sum / count;
}

TEST(ScannerData, TheSimulatedFaceLiesOnItsSurfaceAndIsNoMirrorImage) {
  NEEDS("kretz/synthetic_baby_face.vol");
  const Scan scan = readScan(kData / "kretz/synthetic_baby_face.vol");
  const Mesh truth = readMesh(kData / "kretz/synthetic_baby_face_truth.obj");
  ASSERT_TRUE(scan.mask && scan.beam);
  // What a script of numpy finds in the samples themselves; the peak is thin, and voxels flatten it.
  EXPECT_NEAR(greyAlongNormals(scan, truth, -2), 176, 5);
  EXPECT_NEAR(greyAlongNormals(scan, truth, 0), 224, 5);
  EXPECT_NEAR(greyAlongNormals(scan, truth, 2), 73, 3);
  EXPECT_NEAR(greyAlongNormals(scan, truth, 5), 27, 2);
  Scan mirrored = scan;
  mirrorScan(mirrored, MirroredAxis::j);
  EXPECT_LT(greyAlongNormals(mirrored, truth, 0), 180);
}

// The surface has the face's form; where on the way from fluid to the echo's middle the skin lies is what surface.skinDepth
// says. This simulation has it in the middle, the one that the default is made on half-way there.
TEST(ScannerData, TheSimulatedFaceIsFoundToSixTenthsOfAMillimetre) {
  NEEDS("kretz/synthetic_baby_face.vol");
  const Scan scan = readScan(kData / "kretz/synthetic_baby_face.vol");
  const Mesh truth = readMesh(kData / "kretz/synthetic_baby_face_truth.obj");
  Parameters parameters;
  parameters.surface.skinDepth = 1.2;
  Pipeline pipeline;
  const Results results = pipeline.run(scan, parameters, Goal::mesh);
  ASSERT_TRUE(results.mesh);
  const MeshDistances d = measureDistances(*results.mesh, truth);
  EXPECT_LT(d.aToB.rms, 0.6);
  EXPECT_LT(std::sqrt(d.aToB.rms * d.aToB.rms - d.aToB.signedMedian * d.aToB.signedMedian), 0.3);
  EXPECT_GT(d.aToB.area, 4000);
}

TEST(ScannerData, KretzFilesAreReadOrRefused) {
  NEEDS("kretz/brainphantom_toroidal.vol");
  const fs::path folder = kData / "kretz";
  const Scan toroidal = readScan(folder / "brainphantom_toroidal.vol");
  const Scan cartesian = readScan(folder / "brainphantom_cartesian.vol");
  EXPECT_EQ(cartesian.volume->geometry.dims, glm::ivec3(128, 96, 128));
  EXPECT_EQ(cartesian.volume->geometry.spacing, glm::dvec3(0.25));
  EXPECT_TRUE(toroidal.mask && !cartesian.mask);
  ReadOptions third;
  third.time = 3;
  const Scan moving = readScan(folder / "toshiba_linear_4d_3frames_indexspace.vol", third);
  EXPECT_EQ(moving.volume->geometry.dims, glm::ivec3(219, 45, 74));
  EXPECT_EQ(moving.timeSteps, 3);
  expectError([&] { readScan(folder / "bad_magic.vol"); }, "version");
  expectError([&] { readScan(folder / "bad_truncated.vol"); }, "ends before");
  expectError([&] { readScan(folder / "bad_compressed_flag.vol"); }, "wavelet compression None");
}

// The supplied volume was converted by another program, rounded to bytes.
TEST(ScannerData, ThePyramidBecomesTheVolumeThatWasMadeOfIt) {
  NEEDS("fetus/fetus_00_pyramid.raw");
  ReadOptions options;
  options.raw.dims = {256, 256, 32};
  options.raw.grid = RawGrid::pyramid;
  options.raw.spacing = {0.6, 0.6, 0};
  options.raw.aperture = 0.2 * 153.6;
  options.raw.sweepAngle = 30;
  const Scan ours = readScan(kData / "fetus/fetus_00_pyramid.raw", options);
  const Scan theirs = readScan(kData / "fetus/fetus_00.nrrd");
  const Geometry& g = ours.volume->geometry;
  ASSERT_EQ(g.dims, theirs.volume->geometry.dims);
  EXPECT_LT(glm::distance(g.spacing, theirs.volume->geometry.spacing), 1e-6);
  EXPECT_LT(glm::distance(g.origin, theirs.volume->geometry.origin), 1e-9);
  double worst = 0;
  std::size_t outside = 0;
  for (std::size_t v = 0; v < g.voxels(); ++v) {
    outside += 255 * ours.volume->data[v] < 0.5f;
    worst = std::max(worst, 255 * std::abs(double(ours.volume->data[v] - theirs.volume->data[v])));
  }
  EXPECT_LT(worst, 0.51);
  EXPECT_NEAR(double(outside) / double(g.voxels()), 0.773, 0.001);
}

TEST(ScannerData, ToshibasSamplesBecomeVoxels) {
  NEEDS("us/toshiba_linear/PatientInfo.txt");
  LogRecord record;
  const Scan scan = readScan(kData / "us/toshiba_linear");
  EXPECT_EQ(scan.timeSteps, 2);
  ASSERT_TRUE(scan.mask);
  const glm::dvec3 size = scan.volume->geometry.spacing * glm::dvec3(scan.volume->geometry.dims - 1);
  EXPECT_NEAR(size.x, 47.5, 1);
  EXPECT_NEAR(size.y, 2 * (89.04 + 16.92) * std::sin(glm::radians(14.652)), 1);
  EXPECT_EQ(record.sentences(LogLevel::warning).size(), 1u);
}

}  // namespace
}  // namespace sonoskin
