#include "core/phantom/acoustics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/phantom/random_field.h"

namespace sonoskin {
namespace {

using glm::vec3;

constexpr float kNear = 2;        // mm from an interface within which its angle matters
constexpr float kLostSound = 45;  // dB, two ways; beyond it only clutter is left
constexpr float kOutside = -62;   // dB; also the fluid's own echo

constexpr float kInCord = -1.2f;  // mm; no membrane is as thick

// Losses, dB per mm of depth, there and back.
constexpr float kLossMother = 0.06f, kLossGrazing = 2;

float amplitude(float decibel) { return std::exp(decibel * 0.115129255f); }

float gauss(float x) { return std::exp(-0.5f * x * x); }

// incidence: |cosine| between beam and surface.
float incidence(const DistanceSample& surface, const vec3& beam) {
  return std::abs(glm::dot(surface.gradient, beam)) / (glm::length(surface.gradient) + 1e-6f);
}

// grazes: whether sound at that distance from the skin is bent and scattered away (the shadow of an edge).
bool grazes(float skinDistance, float cosine) {
  return cosine < 0.25f && std::abs(skinDistance + 0.3f) < 0.6f;
}

// Echo: of one sample. scatter and mirror are amplitudes, loss is dB per mm, both ways.
struct Echo {
  float scatter = 0, mirror = 0, loss = 0;
};

// Tissue: what the sound meets at one position.
class Tissue {
 public:
  Tissue(const Anatomy& anatomy, const SectorGrid& sector, const SceneAcoustics& acoustics, int seed)
      : anatomy_(anatomy),
        a_(acoustics.reflection),
        haze_(acoustics.haze),
        layer_(std::max(a_.layer, 0.5f * sector.rangeStep)),
        across_(std::max(sector.lateralStep(), sector.elevationStep())),
        skinKey_(streamKey(seed, 1)),
        dustKey_(streamKey(seed, 2)) {}

  // range: mm from the apex.
  Echo at(const vec3& p, const vec3& beam, float range, std::uint32_t index) const {
    DistanceSample skin{anatomy_.skin.value(p), {}}, wall{anatomy_.wall.value(p), {}};
    if (std::abs(skin.value) < kNear) skin = anatomy_.skin.sample(p);
    if (std::abs(wall.value) < kNear) wall = anatomy_.wall.sample(p);
    const float strands = anatomy_.strands ? anatomy_.strands->value(p) : skin.value + kNear;
    Echo echo;
    if (skin.value < 0)
      echo = inBaby(p, beam, skin);
    else if (wall.value < 0)
      echo = inMother(p, beam, wall);
    else if (strands < kInCord)
      echo = inCord(p);
    else
      echo = inFluid(p, std::min(skin.value, wall.value), skin.value, index);
    if (std::abs(skin.value) < kNear && wall.value > -0.5f) addSkin(echo, p, skin, incidence(skin, beam));
    if (std::abs(wall.value) < kNear && skin.value > 0.5f) addWall(echo, p, wall, incidence(wall, beam));
    if (anatomy_.strands && strands < kNear && skin.value > 0) addStrands(echo, p, beam, range);
    return echo;
  }

 private:
  Echo inFluid(const vec3& p, float clearance, float fromSkin, std::uint32_t index) const {
    constexpr float kParticles = 7e-5f;  // share of the samples that hold a flake of vernix
    const float chance = uniformAt(index, dustKey_);
    const bool vernix = clearance > 1.5f && chance < kParticles;
    if (!vernix && fromSkin < haze_.reach) return {inHaze(p, fromSkin), 0, 0};
    return {amplitude(vernix ? -10 - 14 * chance / kParticles : kOutside), 0, 0};
  }

  // Thick at the skin and in clouds, thin at its end.
  float inHaze(const vec3& p, float fromSkin) const {
    constexpr float kThins = 14, kClouds = 16;  // dB
    const float clouds =
        0.6f * valueNoise(p, 4, dustKey_ + 1) + 0.4f * valueNoise(p, 1.6f, dustKey_ + 2) - 0.5f;
    return amplitude(std::max(haze_.echo - kThins * fromSkin / haze_.reach + kClouds * clouds, kOutside));
  }

  Echo inBaby(const vec3& p, const vec3& beam, const DistanceSample& skin) const {
    const float texture = valueNoise(p, 5, 11) + 0.6f * valueNoise(p, 2.2f, 12) - 0.8f;
    Echo echo{amplitude(-30 + a_.tissue + 5 * texture), 0, a_.lossBaby};
    if (skin.value > -kNear) echo.scatter *= 0.3f + 0.7f * incidence(skin, beam);
    const DistanceSample bone = anatomy_.bone.sample(p);
    if (bone.value < 0) echo = {amplitude(-42), 0, a_.lossBone};
    if (std::abs(bone.value) < 1.2f && skin.value < -0.8f) {
      const float depth = bone.value / std::max(0.35f, layer_);
      echo.mirror = amplitude(a_.bone) * gauss(depth) * reflection(incidence(bone, beam));
    }
    return echo;
  }

  Echo inMother(const vec3& p, const vec3& beam, const DistanceSample& wall) const {
    const vec3 fibres(p.x / 3, p.y * 1.4f, p.z / 3);  // muscle lies in sheets along the wall
    const float texture = valueNoise(fibres, 2, 21) + 0.7f * valueNoise(p, 6, 22) - 0.85f;
    Echo echo{amplitude(-27 + a_.tissue + 9 * texture), 0, kLossMother};
    if (wall.value > -kNear) echo.scatter *= 0.35f + 0.65f * incidence(wall, beam);
    return echo;
  }

  // The skin's echo is patchy: it drops out where the surface is rough or covered with vernix.
  void addSkin(Echo& echo, const vec3& p, const DistanceSample& skin, float cosine) const {
    const float coarse = valueNoise(p, 6, skinKey_), fine = valueNoise(p, 2.2f, skinKey_ + 1);
    const float patch = amplitude(a_.patches * (-14 * coarse * coarse - 5 * fine));
    echo.mirror += amplitude(a_.skin) * patch * gauss((skin.value + 0.45f) / layer_) * reflection(cosine);
    if (grazes(skin.value, cosine)) echo.loss += kLossGrazing;
  }

  void addWall(Echo& echo, const vec3& p, const DistanceSample& wall, float cosine) const {
    const float patch = amplitude(-10 * valueNoise(p, 5, skinKey_ + 2));
    echo.mirror +=
        amplitude(a_.wall) * patch * gauss((wall.value + 0.45f) / (1.2f * layer_)) * reflection(cosine);
  }

  Echo inCord(const vec3& p) const {
    const float texture = valueNoise(p, 2.5f, 31) + valueNoise(p, 5, 32) - 1;
    return {amplitude(-27 + a_.tissue + 6 * texture), 0, kLossMother};
  }

  void addStrands(Echo& echo, const vec3& p, const vec3& beam, float range) const {
    const DistanceSample strands = anatomy_.strands->sample(p);
    const float distance = strands.value, facing = incidence(strands, beam);
    const float width = distance > 0 ? std::max(layer_, 0.3f * across_ * range) : std::max(layer_, 0.5f);
    const float patch = amplitude(-8 * valueNoise(p, 3, skinKey_ + 3));
    echo.mirror += amplitude(-12) * patch * gauss(distance / width) * (0.35f + 0.65f * facing * facing);
  }

  float reflection(float cosine) const { return a_.aside + a_.facing * cosine * cosine * cosine; }

  const Anatomy& anatomy_;
  const ReflectionOptions a_;
  const HazeOptions haze_;
  float layer_;   // mm, standard deviation of a reflecting layer: never thinner than the samples resolve
  float across_;  // rad, how far apart the samples lie across the beam; what is thinner is blurred to that
  std::uint32_t skinKey_, dustKey_;
};

bool inView(const vec3& p) {
  return glm::all(glm::greaterThan(p, vec3(-3))) && glm::all(glm::lessThan(p, vec3(kFieldOfView) + 3.f));
}

}  // namespace

Geometry anatomyGrid(double spacing) {
  const glm::ivec3 cells(glm::ceil(kFieldOfView / spacing));
  return {cells + 3, glm::dvec3(spacing), glm::dvec3(-spacing), glm::dmat3(1)};
}

DistanceGrid sampled(const PhantomModel& model, double (PhantomModel::*distance)(const glm::dvec3&) const,
                     const Geometry& grid, double band, const Progress& progress) {
  const auto at = [&](const glm::dvec3& p) { return (model.*distance)(p); };
  return DistanceGrid(sampleDistance(grid, at, band, progress));
}

Anatomy sampleAnatomy(const PhantomModel& model, double spacing, float skinReach, const Progress& progress) {
  const Geometry grid = anatomyGrid(spacing);
  Anatomy anatomy{
      sampled(model, &PhantomModel::skin, grid, std::max(kNear, skinReach) + spacing, progress.part(0, 0.5)),
      sampled(model, &PhantomModel::bone, grid, 1.2 + spacing, progress.part(0.5, 0.8)),
      sampled(model, &PhantomModel::wall, grid, kNear + spacing, progress.part(0.8, 0.9))};
  if (model.hasStrands())
    anatomy.strands = sampled(model, &PhantomModel::strands, grid, kNear + spacing, progress.part(0.9, 1));
  return anatomy;
}

std::vector<float> echoAmplitude(const SectorGrid& sector, const Anatomy& anatomy, int seed,
                                 const SceneAcoustics& acoustics, const Progress& progress) {
  std::vector<float> out(sector.samples(), amplitude(kOutside));
  const Tissue tissue(anatomy, sector, acoustics, seed);
  parallelFor(
      std::ptrdiff_t(sector.laterals) * sector.elevations,
      [&](std::ptrdiff_t column) {
        const int j = int(column % sector.laterals), k = int(column / sector.laterals);
        const vec3 beam = sector.beam(j, k);
        const std::size_t row = sector.row(j, k);
        float loss = 0;
        for (int i = 0; i < sector.ranges; ++i) {
          const float range = sector.firstRange + float(i) * sector.rangeStep;
          const vec3 p = sector.apex + beam * range;
          if (!inView(p)) continue;
          const Echo echo = tissue.at(p, beam, range, std::uint32_t(row) + std::uint32_t(i));
          loss = std::min(loss + echo.loss * sector.rangeStep, kLostSound);
          out[row + std::size_t(i)] =
              amplitude(-loss) * std::sqrt(echo.scatter * echo.scatter + echo.mirror * echo.mirror);
        }
      },
      progress);
  return out;
}

float lossBefore(const SectorGrid& sector, const TissueDistances& tissues, const vec3& world) {
  constexpr float kSkip = 1, kStep = 0.25f;
  const DistanceGrid &skin = tissues.skin, &wall = tissues.wall;
  const float range = glm::distance(world, sector.apex);
  if (range < sector.firstRange) return std::numeric_limits<float>::infinity();
  const vec3 beam = (world - sector.apex) / range;
  float loss = 0, step = kStep;
  for (float r = sector.firstRange; r < range - kSkip; r += step) {
    const vec3 p = sector.apex + beam * r;
    const float toSkin = skin.value(p);
    const float toStrands = tissues.strands ? tissues.strands->value(p) : kNear + toSkin;
    if (toSkin < 0 || toStrands < kInCord) return std::numeric_limits<float>::infinity();
    step = std::max(kStep, 0.8f * std::min({toSkin - kNear, std::abs(wall.value(p)), toStrands}));
    if (wall.value(p) < 0) loss += kLossMother * step;
    if (toSkin < kNear && grazes(toSkin, incidence(skin.sample(p), beam))) loss += kLossGrazing * step;
  }
  return loss;
}

}  // namespace sonoskin
