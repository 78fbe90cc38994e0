#pragma once

#include "core/phantom/phantom_options.h"
#include "core/phantom/speckle.h"

namespace sonoskin {

// ReflectionOptions: what interfaces send back. Echoes in dB relative to an amplitude of 1.
struct ReflectionOptions {
  float layer = 0.2f;  // mm, standard deviation of a reflecting layer; at least half a sample
  float aside = 0.05f, facing = 0.95f;  // echo of a surface at |cosine| c to the beam: aside + facing c^3
  float skin = -3, bone = -9, wall = -8;
  float patches = 1;                    // how patchy the skin's echo is
  float lossBaby = 0.1f, lossBone = 9;  // dB per mm of depth, there and back
  float tissue = 0;                     // dB on the scattering of the baby's and the mother's tissue
};

// HazeOptions: clutter and reverberation in the fluid before the skin.
struct HazeOptions {
  float echo = -200;  // dB at the skin
  float reach = 0;    // mm from the skin where it ends; 0: none
};

// DisplayOptions: from the envelope to grey.
struct DisplayOptions {
  float white = -4;                  // dB that is shown white
  float range = 50;                  // dB from white to black
  float smoothing = 0;               // mm at the face (standard deviation), before the threshold
  float threshold = 0, ceiling = 1;  // greys that become 0 and 1; those between are spread again
};

// SceneAcoustics: how a scene sounds, in plain numbers, so that they can be fitted.
struct SceneAcoustics {
  PointSpread spread{};
  ReflectionOptions reflection{};
  HazeOptions haze{};
  DisplayOptions display{};
  float receiver = 0;        // dB on the receiver's noise that `snr` brings
  float clutter = 0;         // dB on the clutter that `snr` brings
  float clutterReach = 1;    // times 1.2 mm by 3 by 3 degrees
  float planes = 0;          // rad between planes in elevation; 0: as fine as the voxels show
  float elevationAngle = 0;  // rad, half of the sector's opening in elevation; 0: as wide as usual
};

// sceneAcoustics: the numbers of each scene. assets/docs/phantom.md says what they were fitted to.
SceneAcoustics sceneAcoustics(PhantomScene scene);

}  // namespace sonoskin
