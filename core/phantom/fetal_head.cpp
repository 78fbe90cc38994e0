#include "core/phantom/fetal_head.h"

#include <array>

#include "core/phantom/sdf.h"

namespace sonoskin {
namespace {

using namespace sdf;

// The face is made for one half, x >= 0, and mirrored. Details that touch the middle plane do so at a
// right angle.
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
  float d = ellipsoid(p, {0, 13, -3}, {37.5f, 36, 45});                     // cranium
  d = smoothMin(d, ellipsoid(p, {0, 20, 14}, {27, 22, 29}), 10);            // the forehead's bulge
  d = smoothMin(d, ellipsoid(p, {0, -11, 9}, {29, 25, 28.5f}), 12);         // face
  return smoothMin(d, ellipsoid(p, {0, -24, 10}, {24.5f, 15.5f, 22}), 10);  // jaw
}

void addCheeksAndBrow(Half& h) {
  h.join({{17, -18, 17}, 18}, 9, [&] { return ellipsoid(h.p, {16.5f, -17.5f, 18}, {14.5f, 13.5f, 15.8f}); });
  h.join({{13, -38, 17}, 16}, 7, [&] {
    return capsule(h.p, {{0, -36, 19}, 9}, {{11, -33, 14}, 9});
  });  // double chin
  h.join({{13, 7, 32}, 15}, 6, [&] {
    return chain(
        h.p, std::array<Joint, 3>{{{{3, 6.5f, 35}, 2.5f}, {{12, 8.8f, 35.3f}, 3.2f}, {{23, 6, 26}, 2.5f}}},
        3);
  });
}

// addEye: the socket, and in it the closed lids, two bodies that meet in the line of the lashes.
void addEye(Half& h) {
  const Reach socket{{14.5f, -0.5f, 43.5f}, 10};
  h.carve(socket, 5, [&] { return ellipsoid(h.p, socket.centre, {9.8f, 7.2f, 8.5f}); });
  h.join({{14.5f, -2, 26.5f}, 12}, 2.2f, [&] {
    const float upper = ellipsoid(h.p, {14.5f, 1.2f, 26.4f}, {9.8f, 6.2f, 10});
    const float lower = ellipsoid(h.p, {14.3f, -4.6f, 26.4f}, {8.8f, 3.9f, 8.2f});
    return smoothMin(upper, lower, 0.5f);
  });
  const vec3 q = h.p - vec3(14.5f, 0.7f, 26.3f);
  const float fold = -0.35f * bump((q.y - 3.6f + 0.03f * q.x * q.x) / 1.8f);  // where the open lid would fold
  h.d -= bump(q.x / 9.5f) * bump((q.z - 8) / 8) * fold;
}

void addNose(Half& h) {
  h.join({{0, -4, 36}, 14}, 5, [&] {
    return chain(
        h.p, std::array<Joint, 3>{{{{0, 5, 33.5f}, 3}, {{0, -4, 36.5f}, 3.2f}, {{0, -11, 39.3f}, 3.8f}}}, 2);
  });
  h.join({{0, -12.6f, 40.6f}, 5}, 3, [&] { return ellipsoid(h.p, {0, -12.6f, 40.6f}, {4.9f, 4.1f, 4.6f}); });
  h.join({{5, -14, 37.3f}, 4.6f}, 3, [&] { return ellipsoid(h.p, {5, -14, 37.3f}, {3.2f, 3.2f, 4.5f}); });
  h.carve({{2.9f, -17, 40.6f}, 4}, 0.9f, [&] {
    return capsule(h.p, {{2.5f, -18.2f, 41}, 1.1f}, {{3.5f, -16, 38.8f}, 1.3f});
  });
}

void addMouth(Half& h) {
  h.join({{0, -23, 30}, 14}, 6, [&] {
    return ellipsoid(h.p, {0, -23, 30.5f}, {14.5f, 9.5f, 9.8f});
  });  // the ring muscle
  h.join({{0, -34.5f, 29.5f}, 11}, 6, [&] {
    return ellipsoid(h.p, {0, -34.8f, 29}, {9, 6.5f, 7.5f});
  });  // chin
  const Reach lips{{0, -25, 38}, 13};
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
  const float both = smoothMin(chain(h.p, upper, 0.4f), chain(h.p, lower, 0.4f), 0.4f);
  h.d = smoothMin(h.d, both, 1.6f);
}

// The philtrum, the fold under the lower lip and the mouth's corners: relief, pressed into the skin.
void pressRelief(Half& h) {
  if (h.p.z < 25) return;
  const float front = std::min((h.p.z - 25) / 5, 1.f);
  const float philtrum = -0.7f * bump(h.p.x / 2.1f) * bump((h.p.y + 19.8f) / 3);
  const float ridge = 0.25f * bump((h.p.x - 2.6f) / 1.7f) * bump((h.p.y + 19.8f) / 3);
  const float mouth = -0.6f * bump((h.p.y + 25.9f + 0.006f * h.p.x * h.p.x) / 2) * bump(h.p.x / 12);
  const float corner = -0.5f * bump((h.p.y + 25.6f) / 3) * bump((h.p.x - 11.3f) / 3);
  h.d -= front * front * (philtrum + ridge + mouth + corner);
}

void addEar(Half& h) {
  const Reach reach{{36, -4, -7}, 18};
  if (!reach.joins(h.p, h.d, 3)) return;
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
  float ear = smoothMin(chain(h.p, plate, 1), capsule(h.p, {{36.6f, 4, -9}, 2}, {{36.5f, -3, -10}, 2}), 4);
  ear = smoothMin(ear, chain(h.p, helix, 0.3f), 2);
  ear = smoothMin(ear, chain(h.p, antihelix, 0.3f), 1.8f);
  ear = smoothMin(ear, capsule(h.p, {{35.5f, -3, 0}, 1.9f}, {{36, -5, -1.5f}, 1.6f}), 1.5f);  // tragus
  h.d = smoothMin(h.d, ear, 3);
}

}  // namespace

float headSkin(const glm::vec3& p) {
  Half h{{std::abs(p.x), p.y, p.z}, skullAndJaw(p)};
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

float headBone(const glm::vec3& p) {
  const vec3 q{std::abs(p.x), p.y, p.z};
  float outer = ellipsoid(p, {0, 13, -3}, {33.5f, 32, 41});
  outer = smoothMin(outer, ellipsoid(p, {0, 20, 13}, {23, 18.5f, 26.5f}), 10);
  outer = smoothMin(outer, ellipsoid(p, {0, -13, 7}, {20, 21, 23}), 10);
  float bone = std::max(outer, -(outer + 1.6f));
  bone = std::max(bone, -sphere(q, {14.5f, -1, 27}, 8.5f));        // orbits
  bone = std::max(bone, -ellipsoid(p, {0, -12, 31}, {5, 8, 9}));   // nasal aperture
  bone = std::max(bone, -ellipsoid(p, {0, 42, 16}, {9, 16, 12}));  // the fontanelle
  bone = std::max(bone, std::min(p.y - 12, 1.1f - q.x));           // the seam of the two frontal bones
  bone = std::min(bone, capsule(p, {{0, 1, 34.5f}, 1.2f}, {{0, -5, 36}, 1}));  // nasal bones
  bone = std::min(bone, capsule(p, {{0, -20, -10}, 6}, {{0, -64, -16}, 6}));   // spine
  return bone;
}

}  // namespace sonoskin
