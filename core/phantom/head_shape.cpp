#include "core/phantom/head_shape.h"

#include <algorithm>

#include "core/phantom/random_field.h"

namespace sonoskin {
namespace {

constexpr HeadTrait kTraits[] = {
    {"craniumWidth", &HeadShape::craniumWidth, 0.03f},
    {"craniumHeight", &HeadShape::craniumHeight, 0.03f},
    {"craniumLength", &HeadShape::craniumLength, 0.04f},
    {"forehead", &HeadShape::forehead, 1},
    {"brow", &HeadShape::brow, 0.5f},
    {"faceWidth", &HeadShape::faceWidth, 0.03f},
    {"faceLength", &HeadShape::faceLength, 0.04f},
    {"cheeks", &HeadShape::cheeks, 0.04f},
    {"jawWidth", &HeadShape::jawWidth, 0.04f},
    {"chin", &HeadShape::chin, 1},
    {"jowl", &HeadShape::jowl, 0.06f},
    {"eyeDistance", &HeadShape::eyeDistance, 0.03f},
    {"eyeSize", &HeadShape::eyeSize, 0.05f},
    {"eyeDepth", &HeadShape::eyeDepth, 0.5f},
    {"lidSlant", &HeadShape::lidSlant, 0.4f},
    {"noseLength", &HeadShape::noseLength, 0.05f},
    {"noseWidth", &HeadShape::noseWidth, 0.08f},
    {"noseProjection", &HeadShape::noseProjection, 0.8f},
    {"noseBridge", &HeadShape::noseBridge, 0.5f},
    {"noseTurn", &HeadShape::noseTurn, 0.6f},
    {"nostril", &HeadShape::nostril, 0.1f},
    {"mouthWidth", &HeadShape::mouthWidth, 0.06f},
    {"mouthHeight", &HeadShape::mouthHeight, 0.5f},
    {"upperLip", &HeadShape::upperLip, 0.08f},
    {"lowerLip", &HeadShape::lowerLip, 0.08f},
    {"lips", &HeadShape::lips, 0.5f},
    {"philtrum", &HeadShape::philtrum, 0.2f},
    {"earSize", &HeadShape::earSize, 0.06f},
    {"earStandOff", &HeadShape::earStandOff, 0.6f},
    {"bend", &HeadShape::bend, 0.4f},
    {"skew", &HeadShape::skew, 0.6f},
    {"tilt", &HeadShape::tilt, 0.3f},
};

}  // namespace

std::span<const HeadTrait> headTraits() { return kTraits; }

HeadShape headShape(int seed) {
  HeadShape shape;
  if (seed == 0) return shape;
  constexpr std::uint32_t kStream = 0x4ead;
  const std::uint32_t key = streamKey(seed, kStream);
  std::uint32_t index = 0;
  shape.size = kSmallestHead + (kLargestHead - kSmallestHead) * uniformAt(index++, key);
  for (const HeadTrait& trait : kTraits)
    shape.*trait.number += trait.spread * std::clamp(normalAt(index++, key), -2.f, 2.f);
  return shape;
}

}  // namespace sonoskin
