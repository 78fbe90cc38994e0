#include "core/phantom/fetal_head.h"

#include <array>

#include "core/phantom/sdf.h"

namespace sonoskin {
namespace {

using namespace sdf;

// The face is made for one half, x >= 0, and mirrored. Details that touch the middle plane cross it at right
// angles.
struct Half {
  vec3 p;
  float d;  // the distance so far

  template <class Shape>
  void join(const Reach& reach, float k, Shape&& shape) {
    if (reach.joins(p, d, k)) d = smoothMin(d, shape(), k);
  }
  template <class Shape>
  void carve(const Reach& reach, float k, Shape&& shape) {
    if (reach.carves(p, d, k)) d = smoothMax(d, -shape(), k);
  }
};

float skullAndJaw(const vec3& p) {
  float d = ellipsoid(p, {0, 15, -3}, {37.5f, 38, 45});              // cranium
  d = smoothMin(d, ellipsoid(p, {0, 22, 14}, {27, 24, 29.5f}), 10);  // the forehead's bulge
  d = smoothMin(d, ellipsoid(p, {0, -12, 9}, {28.5f, 25, 29}), 12);  // face
  return d;
}

void addCheeksAndBrow(Half& h) {
  h.join({{18, -18, 19}, 16}, 7, [&] { return ellipsoid(h.p, {17.5f, -18, 19.5f}, {14.5f, 13.5f, 15}); });
  h.join({{12, 8.5f, 33}, 14}, 5, [&] {
    return chain(h.p, std::array<Joint, 3>{{{{3, 6.5f, 35}, 3}, {{12, 9, 35.5f}, 3.4f}, {{22, 7, 29.5f}, 3}}},
                 3);
  });
}

// lashLine: height of the line where the closed lids meet, above the eye's centre, for |x| within the eye.
float lashLine(float x) { return -3.4f + 0.045f * x * x; }

void addEye(Half& h) {
  const vec3 eye{14.5f, -1, 26.5f};
  h.carve({{14.5f, -0.5f, 43.5f}, 9}, 5, [&] {
    return ellipsoid(h.p, {14.5f, -0.5f, 43.5f}, {9.5f, 7, 8.5f});
  });
  h.join({eye, 11}, 2.5f, [&] { return ellipsoid(h.p, eye, {9.8f, 7.4f, 9.4f}); });
  const vec3 q = h.p - eye;
  const float along = bump(q.x / 9.5f);
  if (along <= 0 || std::abs(q.y) > 10 || q.z < 0) return;
  const float above = q.y - lashLine(q.x);
  const float upperLid = 0.5f * bump((above - 2.2f) / 2.2f);  // the upper lid lies on the lower one
  const float lashes = -0.9f * bump(above / 2.1f);
  const float fold = -0.4f * bump((q.y - 4.4f + 0.03f * q.x * q.x) / 1.8f);
  h.d -= along * bump((q.z - 9) / 9) * (upperLid + lashes + fold);
}

void addNose(Half& h) {
  h.join({{0, -4, 37}, 14}, 4, [&] {
    return chain(
        h.p, std::array<Joint, 3>{{{{0, 4, 34.5f}, 2.6f}, {{0, -5, 37.3f}, 2.8f}, {{0, -11, 40.2f}, 3.4f}}},
        2);
  });
  h.join({{0, -12.7f, 41.6f}, 4.5f}, 2, [&] {
    return ellipsoid(h.p, {0, -12.7f, 41.6f}, {4.5f, 3.9f, 4.2f});
  });
  h.join({{5.3f, -14.3f, 38.4f}, 4}, 1.3f, [&] {
    return ellipsoid(h.p, {5.3f, -14.3f, 38.4f}, {3.1f, 3, 4});
  });
  h.carve({{2.9f, -17, 40.6f}, 2.5f}, 0.8f, [&] {
    return capsule(h.p, {{2.4f, -17.6f, 42}, 1.1f}, {{3.4f, -16.2f, 39.2f}, 1.2f});
  });
}

void addMouth(Half& h) {
  h.join({{0, -23, 30}, 14}, 5, [&] {
    return ellipsoid(h.p, {0, -23, 31}, {14, 9.5f, 9.8f});
  });  // the lips' ring muscle
  h.join({{0, -34.5f, 29.5f}, 11}, 5, [&] {
    return ellipsoid(h.p, {0, -34.5f, 29}, {9.5f, 6.8f, 8});
  });  // chin
  const Reach lips{{0, -25, 38}, 13};
  if (!lips.joins(h.p, h.d, 2)) return;
  constexpr std::array<Joint, 4> upper{{{{0, -23.6f, 40.2f}, 2.1f},
                                        {{3, -22.9f, 40}, 2.1f},
                                        {{7, -23.9f, 38.3f}, 1.6f},
                                        {{10.5f, -25.5f, 35.6f}, 0.8f}}};
  constexpr std::array<Joint, 4> lower{{{{0, -27.9f, 39.4f}, 2.3f},
                                        {{4, -27.7f, 39}, 2.1f},
                                        {{7.5f, -26.8f, 37.6f}, 1.5f},
                                        {{10.5f, -25.6f, 35.4f}, 0.8f}}};
  const float both = smoothMin(chain(h.p, upper, 1.5f), chain(h.p, lower, 1.5f), 0.5f);
  h.d = smoothMin(h.d, both, 1.2f);
}

// The philtrum, the fold under the lower lip and the mouth's corners: relief, pressed into the skin.
void pressRelief(Half& h) {
  if (h.p.z < 25 || std::abs(h.d) > 8) return;
  const float front = std::min((h.p.z - 25) / 5, 1.f);
  const float philtrum = -0.75f * bump(h.p.x / 2.2f) * bump((h.p.y + 19.6f) / 3.2f);
  const float ridge = 0.3f * bump((h.p.x - 2.6f) / 1.6f) * bump((h.p.y + 19.6f) / 3.2f);
  const float mouth = -0.7f * bump((h.p.y + 25.6f) / 1.7f) * bump(h.p.x / 13);
  const float corner = -0.8f * bump((h.p.y + 25.5f) / 2.6f) * bump((h.p.x - 11.5f) / 2.8f);
  h.d -= front * front * (philtrum + ridge + mouth + corner);
}

void addEar(Half& h) {
  const Reach reach{{36, -4, -7}, 17};
  if (!reach.joins(h.p, h.d, 3)) return;
  constexpr std::array<Joint, 8> helix{{{{36, 0, 1}, 1.5f},
                                        {{38, 6.5f, -1}, 1.5f},
                                        {{40, 10, -7}, 1.6f},
                                        {{41.5f, 7, -13}, 1.6f},
                                        {{41.5f, 0, -15.5f}, 1.5f},
                                        {{40, -7, -13.5f}, 1.5f},
                                        {{38, -13, -8.5f}, 2.3f},
                                        {{35.5f, -13.5f, -4}, 2.2f}}};
  constexpr std::array<Joint, 4> antihelix{
      {{{39, 5, -6}, 1.2f}, {{40, 1.5f, -10}, 1.4f}, {{39, -5, -10}, 1.4f}, {{37, -9, -6}, 1.5f}}};
  float ear = ellipsoid(h.p, {36.5f, -1.5f, -7}, {2.4f, 11.5f, 8});
  ear = smoothMin(ear, chain(h.p, helix, 1), 1.2f);
  ear = smoothMin(ear, chain(h.p, antihelix, 1), 1);
  ear = smoothMin(ear, capsule(h.p, {{35.5f, -3, 0}, 1.8f}, {{36.5f, -5, -1.5f}, 1.4f}), 1.2f);  // tragus
  h.d = smoothMin(h.d, ear, 2.5f);
}

}  // namespace

float headSkin(const glm::vec3& p) {
  Half h{{std::abs(p.x), p.y, p.z}, skullAndJaw(p)};
  h.join({{0, -46, -8}, 38}, 8, [&] {
    return capsule(h.p, {{0, -24, -7}, 19}, {{0, -64, -14}, 20});
  });  // neck
  addCheeksAndBrow(h);
  addEye(h);
  addNose(h);
  addMouth(h);
  pressRelief(h);
  addEar(h);
  return h.d;
}

float headBone(const glm::vec3& p) {
  const vec3 q{std::abs(p.x), p.y, p.z};
  float outer = ellipsoid(p, {0, 15, -3}, {33.5f, 34, 41});
  outer = smoothMin(outer, ellipsoid(p, {0, 22, 13}, {23, 21, 27}), 10);
  outer = smoothMin(outer, ellipsoid(p, {0, -13, 7}, {20, 21, 23}), 10);
  float bone = std::max(outer, -(outer + 1.6f));
  bone = std::max(bone, -sphere(q, {14.5f, -1, 27}, 8.5f));        // orbits
  bone = std::max(bone, -ellipsoid(p, {0, -12, 31}, {5, 8, 9}));   // nasal aperture
  bone = std::max(bone, -ellipsoid(p, {0, 43, 16}, {9, 16, 12}));  // the fontanelle
  bone = std::max(bone, std::min(p.y - 12, 1.1f - q.x));           // the seam of the two frontal bones
  bone = std::min(bone, capsule(p, {{0, 1, 34.5f}, 1.2f}, {{0, -5, 36}, 1}));  // nasal bones
  bone = std::min(bone, capsule(p, {{0, -20, -10}, 6}, {{0, -64, -16}, 6}));   // spine
  return bone;
}

}  // namespace sonoskin
