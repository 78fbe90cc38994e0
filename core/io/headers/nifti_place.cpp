#include "core/io/headers/nifti_place.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/base/error.h"
#include "core/base/log.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

const glm::dvec3 kRasToLps(-1, -1, 1);

// RAS, in the file's unit.
struct Place {
  glm::dmat3 steps{1};  // from voxel to voxel, one axis per column
  glm::dvec3 origin{0};
};

// [nifti1.h, "UNITS OF SPATIAL AND TEMPORAL DIMENSIONS"]
double millimetresPerUnit(int units) {
  switch (units & 7) {
    case 1:
      return 1000;
    case 2:
      return 1;
    case 3:
      return 1e-3;
    case 0:
      log(LogLevel::warning,
          "The file does not say the unit of its lengths; they are taken for millimetres.");
      return 1;
    default:
      log(LogLevel::warning,
          "The unit of length in the header is not known here; its lengths are taken for millimetres.");
      return 1;
  }
}

double secondsPerUnit(int units) {
  switch (units & 0x38) {
    case 8:
      return 1;
    case 16:
      return 1e-3;
    case 24:
      return 1e-6;
    default:
      return 0;
  }
}

// The size of voxels. [nifti1.h]: pixdim must be positive; its sign says nothing, mirrors are said by qfac
// and the matrix.
glm::dvec3 voxelSize(const NiftiFields& f) {
  glm::dvec3 size(1);
  bool negative = false;
  for (int a = 0; a < 3; ++a) {
    const double given = f.pixdim[std::size_t(a) + 1];
    negative = negative || given < 0;
    if (given != 0) size[a] = std::abs(given);
  }
  if (negative)
    log(LogLevel::warning,
        "The header has a voxel size below zero; its sign is not looked at, as the format asks.");
  return size;
}

// [nifti1.h, "QUATERNION REPRESENTATION OF ROTATION MATRIX"]: 1 less the squares of what is stored.
double restOf(const NiftiFields& f) {
  const double b = f.quaternion[0], c = f.quaternion[1], d = f.quaternion[2];
  return 1 - (b * b + c * c + d * d);
}
bool isRotation(const NiftiFields& f) { return restOf(f) > -1e-3; }

glm::dmat3 rotationOf(const NiftiFields& f) {
  const double b = f.quaternion[0], c = f.quaternion[1], d = f.quaternion[2], rest = restOf(f);
  glm::dmat3 rotation = glm::mat3_cast(glm::normalize(glm::dquat(std::sqrt(std::max(rest, 0.0)), b, c, d)));
  if (f.pixdim[0] < 0) rotation[2] = -rotation[2];
  return rotation;
}

Place byQuaternion(const NiftiFields& f) {
  const glm::dmat3 rotation = rotationOf(f);
  const glm::dvec3 size = voxelSize(f);
  Place place;
  for (int a = 0; a < 3; ++a) place.steps[a] = rotation[a] * size[a];
  place.origin = {f.qoffset[0], f.qoffset[1], f.qoffset[2]};
  return place;
}

Place byMatrix(const NiftiFields& f) {
  Place place;
  for (int r = 0; r < 3; ++r) {
    for (int a = 0; a < 3; ++a) place.steps[a][r] = f.srow[std::size_t(r)][std::size_t(a)];
    place.origin[r] = f.srow[std::size_t(r)][3];
  }
  return place;
}

Place bySize(const NiftiFields& f) {
  const glm::dvec3 size = voxelSize(f);
  Place place;
  for (int a = 0; a < 3; ++a) place.steps[a] *= size[a];
  return place;
}

bool differ(const Place& a, const Place& b) {
  double most = glm::distance(a.origin, b.origin), size = 0;
  for (int n = 0; n < 3; ++n) {
    size = std::max(size, glm::length(a.steps[n]));
    most = std::max(most, glm::distance(a.steps[n], b.steps[n]) * 100);  // of a hundred voxels
  }
  return most > size;
}

// In a float header what is not a number in its range is damage.
bool isSound(double v) { return std::isfinite(v) && (v == 0 || std::abs(v) > 1e-30) && std::abs(v) < 1e30; }

bool hasSoundQuaternion(const NiftiFields& f) {
  return std::all_of(f.quaternion.begin(), f.quaternion.end(), isSound) &&
         std::all_of(f.qoffset.begin(), f.qoffset.end(), isSound);
}

void noteContradictions(const NiftiFields& f, const Place& place) {
  for (int a = 0; a < 3; ++a) {
    const double given = std::abs(f.pixdim[std::size_t(a) + 1]), length = glm::length(place.steps[a]);
    if (given == 0 || std::abs(given - length) <= 1e-3 * length) continue;
    log(LogLevel::warning,
        "The sizes of voxels in the header (pixdim) are not those of its matrix (sform); the matrix holds.");
    break;
  }
  if (f.qformCode <= 0) return;
  if (!hasSoundQuaternion(f) || !isRotation(f))
    log(LogLevel::warning,
        "The header gives a second place (qform) that makes no sense; the first (sform) holds.");
  else if (differ(byQuaternion(f), place))
    log(LogLevel::warning, "The header gives two places, sform and qform, which differ; sform holds.");
}

// What is read of the place: sform where there is one, else qform.
void checkNumbers(const NiftiFields& f, const fs::path& path) {
  require(std::all_of(f.pixdim.begin(), f.pixdim.begin() + 4, isSound),
          "The spacing in {} makes no sense; correct the header.", path.string());
  const bool byMatrix = f.sformCode > 0, byRotation = !byMatrix && f.qformCode > 0;
  bool all = !byRotation || hasSoundQuaternion(f);
  for (std::size_t r = 0; r < 3; ++r)
    all = all && (!byMatrix || std::all_of(f.srow[r].begin(), f.srow[r].end(), isSound));
  require(all, "The origin or the direction of the axes in {} makes no sense; correct the header.",
          path.string());
  require(!byRotation || isRotation(f), "The quaternion in {} is no rotation; correct the header.",
          path.string());
}

}  // namespace

void placeNifti(const NiftiFields& f, StoredVolume& stored, const fs::path& path) {
  checkNumbers(f, path);
  const bool sized = f.pixdim[1] != 0 && f.pixdim[2] != 0 && f.pixdim[3] != 0;
  const Place place = f.sformCode > 0 ? byMatrix(f) : f.qformCode > 0 ? byQuaternion(f) : bySize(f);
  if (f.sformCode > 0) noteContradictions(f, place);
  if (f.sformCode <= 0 && f.qformCode <= 0)
    log(LogLevel::warning,
        "The file does not say where left and right are; its axes are taken for those of RAS.");
  stored.spacingKnown = f.sformCode > 0 || sized;
  const double unit = stored.spacingKnown ? millimetresPerUnit(f.units) : 1;
  Geometry& g = stored.geometry;
  g.origin = kRasToLps * place.origin * unit + 0.0;
  for (int a = 0; a < 3; ++a) {
    const double length = glm::length(place.steps[a]);
    require(length > 0, "An axis in {} has a direction without length (sform); correct the header.",
            path.string());
    g.spacing[a] = length * unit;
    g.direction[a] = kRasToLps * place.steps[a] / length + 0.0;
  }
  const double step = std::abs(f.pixdim[4]) * secondsPerUnit(f.units);
  stored.stepSeconds = std::isfinite(step) ? step : 0;
}

}  // namespace sonoskin
