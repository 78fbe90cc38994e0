#include "core/phantom/fetal_head.h"

#include <array>

#include "core/phantom/sdf.h"

namespace sonoskin {
namespace {

using namespace sdf;

// The face is made for one half, x >= 0, and mirrored. Details that touch the middle plane do so at a
// right angle.
struct Half {
  const HeadShape& shape;
  vec3 p;
  float d;  // the distance so far

  template <class Detail>
  void join(const Reach& reach, float k, Detail&& detail) {
    if (reach.joins(p, d, k)) d = smoothMin(d, detail(), k);
  }
  template <class Detail>
  void carve(const Reach& reach, float k, Detail&& detail) {
    if (reach.carves(p, d, k)) d = smoothMax(d, -detail(), k);
  }
};

// Where the parts of the middle face lie for a shape. Each stays at its depth while the face grows wider or
// longer, for the ellipsoids below do so too.
float eyesApart(const HeadShape& s) { return s.faceWidth * s.eyeDistance; }
float noseLength(const HeadShape& s) { return s.faceLength * s.noseLength; }
float mouthWidth(const HeadShape& s) { return s.faceWidth * s.mouthWidth; }
float mouthRise(const HeadShape& s) { return 26 * (1 - s.faceLength) + s.mouthHeight; }

float skullAndJaw(const vec3& p, const HeadShape& s) {
  const float high = s.craniumHeight, wide = s.craniumWidth, deep = s.craniumLength;
  float d = ellipsoid(p, {0, 13 * high, 42 - 45 * deep}, {37.5f * wide, 36 * high, 45 * deep});
  const vec3 bulge{0, 20 * high, 14 + s.forehead};
  d = smoothMin(d, ellipsoid(p, bulge, {27 * wide, 22 * high, 29}), 10);
  const float across = s.faceWidth, length = s.faceLength;
  d = smoothMin(d, ellipsoid(p, {0, -11 * length, 9}, {29 * across, 25 * length, 28.5f}), 12);
  const vec3 jaw{24.5f * across * s.jawWidth, 15.5f * length, 22};
  return smoothMin(d, ellipsoid(p, {0, -24 * length, 10}, jaw), 10);
}

void addCheeksAndBrow(Half& h) {
  const HeadShape& s = h.shape;
  const float wide = s.faceWidth, length = s.faceLength;
  h.join({{17 * wide, -18 * length, 17}, 18 * s.cheeks}, 9, [&] {
    const vec3 radii{14.5f * s.cheeks, 13.5f * s.cheeks, 15.8f * s.cheeks};
    return ellipsoid(h.p, {16.5f * wide, -17.5f * length, 18}, radii);
  });
  const float jaw = wide * s.jawWidth;
  h.join({{13 * jaw, -38 * length, 17}, 16 * s.jowl * std::max(1.f, jaw)}, 7, [&] {
    return capsule(h.p, {{0, -36 * length, 19}, 9 * s.jowl}, {{11 * jaw, -33 * length, 14}, 9 * s.jowl});
  });  // double chin
  const float brow = s.brow + 0.5f * s.forehead;
  h.join({{13 * wide, 7, 32 + brow}, 15 * std::max(1.f, wide)}, 6, [&] {
    return chain(h.p,
                 std::array<Joint, 3>{{{{3 * wide, 6.5f, 35 + brow}, 2.5f},
                                       {{12 * wide, 8.8f, 35.3f + brow}, 3.2f},
                                       {{23 * wide, 6, 26 + brow}, 2.5f}}},
                 3);
  });
}

// addEye: the socket, and in it the closed lids, two bodies that meet in the line of the lashes.
void addEye(Half& h) {
  const HeadShape& s = h.shape;
  const float apart = eyesApart(s), size = s.eyeSize, back = s.eyeDepth;
  const vec3 p{h.p.x, h.p.y - s.lidSlant * (h.p.x - 14.5f * apart) * 0.1f, h.p.z};
  const Reach socket{{14.5f * apart, -0.5f, 43.5f - back}, 10 * std::max(1.f, size)};
  h.carve(socket, 5, [&] { return ellipsoid(h.p, socket.centre, {9.8f * size, 7.2f * size, 8.5f}); });
  h.join({{14.5f * apart, -2, 26.5f - back}, 12 * std::max(1.f, size)}, 2.2f, [&] {
    const float upper =
        ellipsoid(p, {14.5f * apart, 1.2f * size, 26.4f - back}, {9.8f * size, 6.2f * size, 10});
    const float lower =
        ellipsoid(p, {14.3f * apart, -4.6f * size, 26.4f - back}, {8.8f * size, 3.9f * size, 8.2f});
    return smoothMin(upper, lower, 0.5f);
  });
  const vec3 q = (p - vec3(14.5f * apart, 0.7f, 26.3f - back)) / size;
  const float fold = -0.35f * bump((q.y - 3.6f + 0.03f * q.x * q.x) / 1.8f);  // where the open lid would fold
  h.d -= bump(q.x / 9.5f) * bump((q.z - 8) / 8) * fold;
}

void addNose(Half& h) {
  const HeadShape& s = h.shape;
  const float down = noseLength(s), wide = s.noseWidth;
  const float root = s.noseBridge, tip = s.noseProjection, middle = 0.5f * (root + tip);
  h.join({{0, -4 * down, 36 + middle}, 14 * std::max(1.f, down)}, 5, [&] {
    return chain(h.p,
                 std::array<Joint, 3>{{{{0, 5, 33.5f + root}, 3},
                                       {{0, -4 * down, 36.5f + middle}, 3.2f},
                                       {{0, -11 * down + 0.6f * s.noseTurn, 39.3f + tip}, 3.8f}}},
                 2);
  });
  const vec3 ball{0, -12.6f * down + s.noseTurn, 40.6f + tip};
  h.join({ball, 5 * std::max(1.f, wide)}, 3, [&] { return ellipsoid(h.p, ball, {4.9f * wide, 4.1f, 4.6f}); });
  const vec3 wing{5 * wide, -14 * down, 37.3f + 0.6f * tip};
  h.join({wing, 4.6f * std::max(1.f, wide)}, 3, [&] {
    return ellipsoid(h.p, wing, {3.2f * wide, 3.2f, 4.5f});
  });
  const float under = 17 * (1 - down) + 0.5f * s.noseTurn, before = 0.8f * tip;
  h.carve({{2.9f * wide, -17 + under, 40.6f + before}, 4 * std::max({1.f, wide, s.nostril})}, 0.9f, [&] {
    return capsule(h.p, {{2.5f * wide, -18.2f + under, 41 + before}, 1.1f * s.nostril},
                   {{3.5f * wide, -16 + under, 38.8f + before}, 1.3f * s.nostril});
  });
}

// lip: joints of the first head's lip where the shape has them; `full` also moves them off the line between
// the lips, so that the line stays.
template <std::size_t n>
std::array<Joint, n> lip(const std::array<Joint, n>& first, const HeadShape& s, float full) {
  const float wide = mouthWidth(s), rise = mouthRise(s);
  std::array<Joint, n> joints;
  for (std::size_t i = 0; i < n; ++i) {
    const vec3& at = first[i].at;
    joints[i] = {{at.x * wide, at.y + rise + (at.y + 26) * (full - 1), at.z + s.lips},
                 first[i].radius * full};
  }
  return joints;
}

void addMouth(Half& h) {
  const HeadShape& s = h.shape;
  const float wide = mouthWidth(s), rise = mouthRise(s);
  h.join({{0, -23 + rise, 30}, 14 * std::max(1.f, wide)}, 6, [&] {
    return ellipsoid(h.p, {0, -23 + rise, 30.5f}, {14.5f * wide, 9.5f, 9.8f});
  });  // the ring muscle
  const vec3 chin{0, -34.8f * s.faceLength, 29 + s.chin};
  h.join({chin + vec3(0, 0.3f, 0.5f), 11}, 6, [&] { return ellipsoid(h.p, chin, {9, 6.5f, 7.5f}); });
  const Reach lips{{0, -25 + rise, 38 + s.lips}, 13 * std::max(1.f, wide)};
  if (!lips.joins(h.p, h.d, 2)) return;
  constexpr std::array<Joint, 5> upper{{{{0, -24.2f, 39.2f}, 2.2f},
                                        {{2.6f, -23.2f, 39.1f}, 2.2f},
                                        {{6, -23.9f, 37.8f}, 2.1f},
                                        {{9, -25.3f, 35.5f}, 1.6f},
                                        {{11, -26.3f, 33.6f}, 1}}};
  constexpr std::array<Joint, 5> lower{{{{0, -28, 38.3f}, 2.4f},
                                        {{3.2f, -28, 38}, 2.4f},
                                        {{6.2f, -27.4f, 36.8f}, 2},
                                        {{9, -26.8f, 34.9f}, 1.4f},
                                        {{11, -26.5f, 33.4f}, 1}}};
  const float both = smoothMin(chain(h.p, lip(upper, s, s.upperLip), 0.4f),
                               chain(h.p, lip(lower, s, s.lowerLip), 0.4f), 0.4f);
  h.d = smoothMin(h.d, both, 1.6f);
}

// The philtrum, the fold under the lower lip and the mouth's corners: relief, pressed into the skin.
void pressRelief(Half& h) {
  if (h.p.z < 25) return;
  const float front = std::min((h.p.z - 25) / 5, 1.f), rise = mouthRise(h.shape);
  const float x = h.p.x, y = h.p.y - rise, across = x / mouthWidth(h.shape), deep = h.shape.philtrum;
  const float philtrum = -0.7f * deep * bump(x / 2.1f) * bump((y + 19.8f) / 3);
  const float ridge = 0.25f * deep * bump((x - 2.6f) / 1.7f) * bump((y + 19.8f) / 3);
  const float mouth = -0.6f * bump((y + 25.9f + 0.006f * across * across) / 2) * bump(across / 12);
  const float corner = -0.5f * bump((y + 25.6f) / 3) * bump((across - 11.3f) / 3);
  h.d -= front * front * (philtrum + ridge + mouth + corner);
}

void addEar(Half& h) {
  const HeadShape& s = h.shape;
  const vec3 middle{36, -4, -7},
      move{33 * (s.craniumWidth - 1) + s.earStandOff, 0, 22.5f * (1 - s.craniumLength)};
  const Reach reach{middle + move, 18 * s.earSize};
  if (!reach.joins(h.p, h.d, 3)) return;
  const vec3 moved = h.p - move, p = moved + (moved - middle) * (1 / s.earSize - 1);
  constexpr std::array<Joint, 10> helix{{{{35.5f, -1, 0}, 1.5f},
                                         {{37, 3.5f, 0.5f}, 1.6f},
                                         {{38.3f, 7.5f, -2}, 1.7f},
                                         {{39.3f, 9.5f, -6}, 1.8f},
                                         {{40.3f, 8.3f, -10.5f}, 1.8f},
                                         {{40.6f, 4, -13.5f}, 1.8f},
                                         {{40, -1.5f, -14}, 1.7f},
                                         {{38.8f, -7, -12}, 1.7f},
                                         {{37.2f, -11.5f, -8.5f}, 2.4f},
                                         {{35, -12.5f, -4.5f}, 2.3f}}};
  constexpr std::array<Joint, 5> antihelix{{{{38, 4.5f, -5}, 1.3f},
                                            {{39, 2.5f, -8.5f}, 1.5f},
                                            {{38.6f, -2, -9.5f}, 1.5f},
                                            {{37.6f, -6, -8.5f}, 1.5f},
                                            {{36.5f, -8.5f, -5.5f}, 1.5f}}};
  constexpr std::array<Joint, 4> plate{
      {{{35.5f, -11, -5}, 1.6f}, {{36, -4, -7}, 2.2f}, {{36.5f, 2, -7}, 2.2f}, {{37, 7, -5}, 1.8f}}};
  float ear = smoothMin(chain(p, plate, 1), capsule(p, {{36.6f, 4, -9}, 2}, {{36.5f, -3, -10}, 2}), 4);
  ear = smoothMin(ear, chain(p, helix, 0.3f), 2);
  ear = smoothMin(ear, chain(p, antihelix, 0.3f), 1.8f);
  ear = smoothMin(ear, capsule(p, {{35.5f, -3, 0}, 1.9f}, {{36, -5, -1.5f}, 1.6f}), 1.5f);  // tragus
  h.d = smoothMin(h.d, s.earSize * ear, 3);
}

// straight: where a place of a lopsided head lies in the even one; shears, which hardly stretch.
vec3 straight(vec3 p, const HeadShape& s) {
  const float below = std::max(-p.y, 0.f), aside = p.x / std::sqrt(900 + p.x * p.x);
  p.x -= s.bend * below * below / (300 + 15 * below);  // 1 at the mouth
  p.y -= s.tilt * aside;
  p.z -= s.skew * aside;
  return p;
}

float evenSkin(const vec3& p, const HeadShape& shape) {
  Half h{shape, {std::abs(p.x), p.y, p.z}, skullAndJaw(p, shape)};
  h.join({{0, -46, -8}, 38}, 8, [&] {
    return capsule(h.p, {{0, -22, -6}, 19}, {{0, -60, -14}, 20});
  });  // neck
  addCheeksAndBrow(h);
  addEye(h);
  addNose(h);
  addMouth(h);
  pressRelief(h);
  addEar(h);
  return h.d;
}

float evenBone(const vec3& p, const HeadShape& s) {
  const float high = s.craniumHeight, wide = s.craniumWidth, deep = s.craniumLength, across = s.faceWidth;
  const float length = s.faceLength;
  const vec3 q{std::abs(p.x), p.y, p.z};
  float outer = ellipsoid(p, {0, 13 * high, 38 - 41 * deep}, {33.5f * wide, 32 * high, 41 * deep});
  outer =
      smoothMin(outer, ellipsoid(p, {0, 20 * high, 13 + s.forehead}, {23 * wide, 18.5f * high, 26.5f}), 10);
  outer = smoothMin(outer, ellipsoid(p, {0, -13 * length, 7}, {20 * across, 21 * length, 23}), 10);
  float bone = std::max(outer, -(outer + 1.6f));
  const vec3 orbit{14.5f * eyesApart(s), -1, 27 - s.eyeDepth};
  bone = std::max(bone, -sphere(q, orbit, 8.5f * s.eyeSize));
  bone = std::max(bone, -ellipsoid(p, {0, -12 * length, 31}, {5, 8, 9}));              // nasal aperture
  bone = std::max(bone, -ellipsoid(p, {0, 42 * high, 16 + s.forehead}, {9, 16, 12}));  // the fontanelle
  bone = std::max(bone, std::min(p.y - 12, 1.1f - q.x));  // the seam of the two frontal bones
  const float middle = 36 + 0.5f * (s.noseBridge + s.noseProjection);
  bone = std::min(bone, capsule(p, {{0, 1, 34.5f + s.noseBridge}, 1.2f},
                                {{0, -5 * noseLength(s), middle}, 1}));       // nasal bones
  return std::min(bone, capsule(p, {{0, -20, -10}, 6}, {{0, -64, -16}, 6}));  // spine
}

// onFace: the skin of a head at x to its left and y upward, seen from before it.
vec3 onFace(float x, float y, const HeadShape& shape) {
  constexpr float kBefore = 60, kCloseEnough = 1e-3f;
  vec3 even{x, y, kBefore};
  for (float d = evenSkin(even, shape); d > kCloseEnough && even.z > 0; d = evenSkin(even, shape))
    even.z -= 0.7f * d;
  vec3 p = even;
  for (int step = 0; step < 4; ++step) p += even - straight(p, shape);
  return shape.size * p;
}

}  // namespace

float headSkin(const vec3& p, const HeadShape& shape) {
  return shape.size * evenSkin(straight(p / shape.size, shape), shape);
}

float headSkin(const vec3& p) {
  static constexpr HeadShape kFirst;
  return headSkin(p, kFirst);
}

float headBone(const vec3& p, const HeadShape& shape) {
  return shape.size * evenBone(straight(p / shape.size, shape), shape);
}

float headBone(const vec3& p) {
  static constexpr HeadShape kFirst;
  return headBone(p, kFirst);
}

HeadPlaces headPlaces(const HeadShape& s) {
  const float eye = 14.4f * eyesApart(s), corner = 11 * mouthWidth(s), mouth = -26.4f + mouthRise(s);
  const float tip = -12.6f * noseLength(s) + s.noseTurn;
  return {onFace(-eye, -1.4f * s.eyeSize, s),
          onFace(eye, -1.4f * s.eyeSize, s),
          onFace(0, tip, s),
          onFace(-corner, mouth, s),
          onFace(corner, mouth, s),
          onFace(0, -34.8f * s.faceLength, s)};
}

}  // namespace sonoskin
