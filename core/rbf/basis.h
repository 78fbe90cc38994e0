#pragma once

namespace sonoskin {

// wendland: the C2 basis function φ(t) = (1-t)^4 (4t+1), zero from t = 1 on.       [Wendland 1995; thesis
// Tab. 2.1]
//   t   distance / support, >= 0
// Kept free of branches so that loops over it become vector code.
inline float wendland(float t) {
  float s = 1 - t;
  s = s > 0 ? s : 0;
  s *= s;
  return s * s * (4 * t + 1);
}

// wendlandGradientFactor: f in ∇φ(|x-c|/σ) = f (x-c)/σ², f = -20 (1-t)³: no singularity at x = c.
inline float wendlandGradientFactor(float t) {
  float s = 1 - t;
  s = s > 0 ? s : 0;
  return -20 * s * s * s;
}

}  // namespace sonoskin
