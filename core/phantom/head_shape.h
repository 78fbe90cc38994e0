#pragma once

#include <span>

namespace sonoskin {

// HeadShape: a head of the family that the phantom draws from and the face's search fits. The numbers of the
// first head are the defaults. Factors are times the first head's measure; mm are before `size`.
struct HeadShape {
  float size = 1;  // the whole head; 1 is 75 mm across and 92 from crown to chin

  float craniumWidth = 1;   // from side to side
  float craniumHeight = 1;  // from the eyes to the crown
  float craniumLength = 1;  // from the forehead to the back; the forehead stays
  float forehead = 0;       // mm that it bulges further forward
  float brow = 0;           // mm that the ridge over the eyes stands further forward

  float faceWidth = 1;   // of the middle face, with the eyes and the mouth in it
  float faceLength = 1;  // from the eyes to the chin
  float cheeks = 1;      // how full they are
  float jawWidth = 1;    // beside that of the face
  float chin = 0;        // mm that it stands further forward
  float jowl = 1;        // how thick the double chin is

  float eyeDistance = 1;  // between the eyes, beside the width of the face
  float eyeSize = 1;      // of the closed lids and of the socket
  float eyeDepth = 0;     // mm that the lids lie further back
  float lidSlant = 0;     // mm that the outer corners are higher

  float noseLength = 1;      // from the root to the tip, beside the length of the face
  float noseWidth = 1;       // of the tip and between the wings
  float noseProjection = 0;  // mm that the tip stands further forward
  float noseBridge = 0;      // mm that the root stands further forward
  float noseTurn = 0;        // mm that the tip is turned up
  float nostril = 1;         // how wide it is

  float mouthWidth = 1;   // from corner to corner, beside the width of the face
  float mouthHeight = 0;  // mm that the mouth lies higher
  float upperLip = 1;     // how full it is
  float lowerLip = 1;
  float lips = 0;      // mm that both stand further forward
  float philtrum = 1;  // how deep the groove over the lip is

  float earSize = 1;
  float earStandOff = 0;  // mm that the ears stand further off

  float bend = 0;  // mm that the mouth lies further to the left than the eyes
  float skew = 0;  // mm that the left side lies further forward
  float tilt = 0;  // mm that the left side lies higher

  bool operator==(const HeadShape&) const = default;
};

// HeadTrait: how much a number of the shape differs from head to head.
struct HeadTrait {
  const char* name;
  float HeadShape::*number;
  float spread;  // standard deviation; no head differs from the first by more than twice that
};

// headTraits: all numbers but the size.
std::span<const HeadTrait> headTraits();

// Sizes of heads from the middle of pregnancy's last third to some days after birth.
inline constexpr float kSmallestHead = 0.75f, kLargestHead = 1.1f;

// headShape: a head by number: 0 is the first head, every other number one drawn at random, each trait by
// itself, the size evenly between kSmallestHead and kLargestHead.
//   source   ours: ranges by eye, so that heads stay those of newborns
HeadShape headShape(int seed);

}  // namespace sonoskin
