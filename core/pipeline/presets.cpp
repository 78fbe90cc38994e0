#include "core/pipeline/presets.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "core/base/error.h"
#include "core/pipeline/parameter_key.h"

namespace sonoskin {
namespace {

void smoothSkin(Parameters& p) {
  p.classification.lowPass = 1.75;
  p.classification.tangentialLength = 4;
  p.reconstruction.smoothness = 5e-5;
}

void detailedSkin(Parameters& p) {
  p.classification.lowPass = 1.2;
  p.classification.tangentialLength = 2;
  p.reconstruction.smoothness = 1e-5;
}

// What both examples of the thesis share: chapters 3 and 4, and for the thinning its program.
void thesis(Parameters& p) {
  ClassificationOptions& c = p.classification;
  c.formulation = Formulation::thesisClosed;
  c.beta = 0.2;
  c.rawShare = 0.5;
  c.gradientFloor = 0.5;
  c.target = 0.9;
  c.rescale = true;
  SurfaceOptions& s = p.surface;
  s.thinning = ThinningMethod::thesis;
  s.thresholdScale = ThresholdScale::one;
  s.threshold = 0.15;
  s.clusters = ClusterRule::largest;
  s.minClusterArea = 0;
  s.facing = -1;
  s.sides = 0;
  s.borderMargin = 0;
  s.firstHit = 0;
  s.offsetCorrection = false;
  p.reconstruction.method = ReconstructionMethod::thesis;
  p.reconstruction.regularisation = 1e-6;
  p.reconstruction.fitWeights = true;
  p.mesh.density = 0;
  p.mesh.narrowest = 0;
  p.mesh.fillHoles = 0;
}

// The first rows of the thesis' tables 4.1 and 4.2; T_sa is that of the result which it calls smooth with details.
void thesisBaby1(Parameters& p) {
  thesis(p);
  p.classification.alpha = 0.7;
  p.classification.gamma = 0.7;
  p.classification.isoValue = 0.6;
  p.reconstruction.smoothness = 2e-5;
}

// The last rows of the same tables.
void thesisBaby2(Parameters& p) {
  thesis(p);
  p.classification.alpha = 0.9;
  p.classification.gamma = 0.4;
  p.classification.isoValue = 0.3;
  p.reconstruction.smoothness = 1e-4;
}

constexpr std::array kPresets{
    Preset{"default", "the settings that suit most scans", [](Parameters&) {}},
    Preset{"smooth", "for noisy scans: calm skin, but small features such as lids and lips grow faint",
           smoothSkin},
    Preset{"detailed", "for clear scans: finer features, and more of the noise", detailedSkin},
    Preset{"thesis-baby-1",
           "the thesis' own way and settings for its first volume, to compare: rough, and only for scans "
           "whose skin "
           "is brighter than the iso-value 0.6; keeps walls and the scan's border",
           thesisBaby1},
    Preset{
        "thesis-baby-2",
        "the thesis' own way and settings for its second volume, to compare: noisier than the default; keeps "
        "walls and the scan's border, which may hide the face",
        thesisBaby2}};

Key keyOfPresetGroups(const Parameters& p) {
  Hasher hasher("preset");
  addOptions(hasher, p.classification);
  addOptions(hasher, p.surface);
  addOptions(hasher, p.reconstruction);
  return hasher.key();
}

}  // namespace

std::span<const Preset> presets() { return kPresets; }

const Preset& findPreset(std::string_view name) {
  std::string names;
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return preset;
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", preset.name);
  }
  throw Error(fmt::format("there is no preset \"{}\"; choose one of {}", name, names), Error::Kind::usage);
}

void applyPreset(const Preset& preset, Parameters& parameters) {
  parameters.classification = {};
  parameters.surface = {};
  parameters.reconstruction = {};
  const MeshOptions usual;  // of the mesh, presets change the border alone
  parameters.mesh.density = usual.density;
  parameters.mesh.narrowest = usual.narrowest;
  parameters.mesh.fillHoles = usual.fillHoles;
  preset.change(parameters);
}

const Preset* matchingPreset(const Parameters& parameters) {
  const Key key = keyOfPresetGroups(parameters);
  for (const Preset& preset : kPresets) {
    Parameters candidate;
    applyPreset(preset, candidate);
    if (keyOfPresetGroups(candidate) == key) return &preset;
  }
  return nullptr;
}

}  // namespace sonoskin
