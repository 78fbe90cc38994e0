#include "core/pipeline/scan_doubts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "core/base/error.h"
#include "core/io/volume_reader.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"

namespace sonoskin {
namespace {

// A scan of 64^3 voxels of 1.5 mm whose grey is f(distance from the middle, mm).
template <class F>
Scan scanOf(const F& f) {
  Geometry g;
  g.dims = {64, 64, 64};
  g.spacing = glm::dvec3(1.5);
  Volume<float> volume(g);
  for (int k = 0; k < 64; ++k)
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i < 64; ++i)
        volume.at(i, j, k) =
            std::clamp(f(1.5f * glm::length(glm::vec3(i, j, k) - glm::vec3(31.5f))), 0.f, 1.f);
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(std::move(volume));
  scan.key = scanKey(*scan.volume, scan.beam);
  return scan;
}

Results pointsOf(const Scan& scan) {
  Pipeline pipeline;
  return pipeline.run(scan, Parameters{}, Goal::points);
}

// The only warning, and what it must speak of.
void expectDoubt(const Scan& scan, const std::string& word) {
  const std::vector<std::string> warnings = pointsOf(scan).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find(word), std::string::npos) << warnings[0];
}

TEST(ScanDoubts, NoiseAndOneGreyAreNoSurface) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> grey(0, 1);
  expectDoubt(scanOf([&](float) { return grey(random); }), "noise");
  expectDoubt(scanOf([](float) { return 0.4f; }), "but one grey");
  Pipeline pipeline;
  try {
    pipeline.run(scanOf([](float) { return 0.4f; }), Parameters{}, Goal::mesh);
    ADD_FAILURE() << "a mesh of nothing";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no surface was found: there is but one grey"),
              std::string::npos)
        << error.what();
  }
}

TEST(ScanDoubts, ABallThatIsAsSharpAllAroundIsNoUltrasound) {
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, 0.01f);
  const auto ct = [&](float d) {
    return (d > 40 ? 0.02f : d > 36 ? 0.27f : d > 30 ? 0.6f : 0.28f) + noise(random);
  };
  expectDoubt(scanOf(ct), "CT or an MRI");
  const auto mri = [&](float d) { return 0.5f / (1 + std::exp((d - 40) / 1.5f)) + std::abs(noise(random)); };
  expectDoubt(scanOf(mri), "CT or an MRI");
}

TEST(ScanDoubts, TheSimulatedScanIsNotDoubtedInHardScenesNorInNoise) {
  Parameters parameters;
  parameters.phantom.dims = {117, 64, 31};
  using enum PhantomScene;
  for (const auto& [scene, snr] : {std::pair{clear, 8.0}, {haze, 40.0}, {hands, 8.0}, {clinical, 20.0}}) {
    parameters.phantom.scene = scene;
    parameters.phantom.snr = snr;
    const Results results = pointsOf(makePhantomScan(parameters.phantom));
    EXPECT_TRUE(results.warnings.empty())
        << enumNames(scene)[std::size_t(scene)] << " at " << snr << " dB: " << results.warnings.front();
  }
}

ScanEvidence good() {
  ScanEvidence e;
  e.noise = 0.03, e.dark = 0.75, e.sideways = 0.3, e.clear = 0.8, e.largest = 0.6, e.rise = 0.4,
  e.width = 1.4;
  return e;
}
Scan goodScan() {
  return scanOf([](float) { return 0.5f; });
}

TEST(ScanDoubts, EachKindOfEvidenceHasItsSentence) {
  const Scan scan = goodScan();
  const auto doubt = [&](auto change) {
    ScanEvidence e = good();
    change(e);
    const std::vector<std::string> doubts = doubtsOf(scan, e, nullptr, {});
    return doubts.size() == 1 ? doubts[0] : std::string();
  };
  EXPECT_TRUE(doubtsOf(scan, good(), nullptr, {}).empty());
  EXPECT_NE(doubt([](ScanEvidence& e) { e.rise = 0.05; }).find("noise"), std::string::npos);
  EXPECT_NE(doubt([](ScanEvidence& e) { e.sideways = 0.45; }).find("all ways"), std::string::npos);
  EXPECT_NE(doubt([](ScanEvidence& e) { e.dark = 0.1; }).find("only 10 %"), std::string::npos);
  EXPECT_NE(doubt([](ScanEvidence& e) { e.clear = 0.5; }).find("only 50 %"), std::string::npos);
  EXPECT_NE(doubt([](ScanEvidence& e) { e.width = 6; }).find("6.0 mm"), std::string::npos);
  EXPECT_NE(doubt([](ScanEvidence& e) { e.largest = 0.1; }).find("in pieces"), std::string::npos);
}

TEST(ScanDoubts, TheFileAndTheSizeSpeakToo) {
  Scan scan = goodScan();
  scan.modality = "US";
  EXPECT_TRUE(doubtsOf(scan, good(), nullptr, {}).empty());
  scan.modality = "MR";
  ASSERT_EQ(doubtsOf(scan, good(), nullptr, {}).size(), 1u);
  EXPECT_NE(doubtsOf(scan, good(), nullptr, {})[0].find("an MRI"), std::string::npos);
  scan.modality.clear();
  scan.originalMin = -1000;
  EXPECT_NE(doubtsOf(scan, good(), nullptr, {}).at(0).find("-1000"), std::string::npos);
  scan.originalMin = 0;
  Volume<float> large = *scan.volume;
  large.geometry.spacing = glm::dvec3(8);
  scan.volume = std::make_shared<const Volume<float>>(std::move(large));
  EXPECT_NE(doubtsOf(scan, good(), nullptr, {}).at(0).find("512 mm"), std::string::npos);
}

TEST(ScanDoubts, WithoutAFaceTheEvidenceMustBeBetter) {
  const Scan scan = goodScan();
  ScanEvidence doubtful = good();
  doubtful.clear = 0.65;
  FaceFit face;
  face.confidence = 0.1f;
  EXPECT_TRUE(doubtsOf(scan, doubtful, nullptr, {}).empty()) << "none was looked for";
  EXPECT_EQ(doubtsOf(scan, doubtful, &face, {}).size(), 1u);
  EXPECT_TRUE(doubtsOf(scan, good(), &face, {}).empty());
  face.confidence = 0.9f;
  face.headHeight = 85;
  EXPECT_TRUE(doubtsOf(scan, doubtful, &face, {}).empty());
  face.headHeight = 30;
  EXPECT_NE(doubtsOf(scan, doubtful, &face, {}).at(0).find("spacing"), std::string::npos);
}

TEST(ScanDoubts, EvidenceDoesNotDependOnWhereNothingWasFound) {
  const Scan scan = goodScan();
  const SurfacePoints none;
  const ScanEvidence e = weighEvidence({*scan.volume, *scan.volume, {}, {}, {}, none, {}});
  EXPECT_FALSE(e.hasEdges);
  EXPECT_EQ(e.clear, 1);
  EXPECT_EQ(e.largest, 1);
}

struct RealScan {
  const char* file;
  const char* word;  // of the first warning; empty: there must be none
};

TEST(ScanDoubts, RealScansOfAFaceAreNotDoubtedAndOthersAre) {
  const std::filesystem::path folder = SONOSKIN_SHARED_DATA;
  for (const RealScan& real :
       {RealScan{"fetus/fetus_00.nrrd", ""}, RealScan{"fetus/fetus_09.nrrd", ""},
        RealScan{"us/ibis_brain_phantom/brain_phantom_0p25mm.nrrd", "dark as fluid"},
        RealScan{"us/itksnap_echo/ultrasound_img4d.nii.gz", "all ways"},
        RealScan{"us/plus_bone/vtkVolumeReconstructorTestLNMEANvolumeRef.mha", "all ways"},
        RealScan{"ct/slicer_head", "a CT"}}) {
    if (!std::filesystem::exists(folder / real.file)) GTEST_SKIP() << "no " << real.file;
    const std::vector<std::string> warnings = pointsOf(readScan(folder / real.file)).warnings;
    if (*real.word == 0)
      EXPECT_TRUE(warnings.empty()) << real.file << ": " << warnings.front();
    else
      EXPECT_TRUE(!warnings.empty() && warnings[0].find(real.word) != std::string::npos) << real.file;
  }
}

}  // namespace
}  // namespace sonoskin
