#include "core/mesh/repair/decimate.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/half_edges.h"

namespace sonoskin {
namespace {

std::vector<Triangle> simplify(const std::vector<glm::vec3>& positions,
                               const std::vector<Triangle>& triangles, std::size_t wanted) {
  std::vector<Triangle> reduced(triangles.size());
  const std::size_t indices = meshopt_simplify(reduced[0].data(), triangles[0].data(), 3 * triangles.size(),
                                               &positions[0].x, positions.size(), sizeof(glm::vec3),
                                               3 * wanted, 1.f, meshopt_SimplifyLockBorder, nullptr);
  reduced.resize(indices / 3);
  return reduced;
}

using Call = std::packaged_task<std::vector<Triangle>()>;

// AbandonedCalls: calls that nobody waits for any more. They end by themselves, but not at once: the next call lets them, so that
// however often somebody thinks better of it, one thread and one copy of a mesh at most are left behind.
class AbandonedCalls {
 public:
  void add(std::weak_ptr<Call> call) {
    const std::lock_guard lock(mutex_);
    calls_.push_back(std::move(call));
  }
  void letEnd(const Progress& progress) {
    while (!haveEnded()) {
      progress.throwIfCancelled();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

 private:
  bool haveEnded() {
    const std::lock_guard lock(mutex_);
    std::erase_if(calls_, [](const std::weak_ptr<Call>& call) { return call.expired(); });
    return calls_.empty();
  }

  std::mutex mutex_;
  std::vector<std::weak_ptr<Call>> calls_;
};

// The same on a thread of its own, with data of its own, so that a cancel need not wait for the library.
std::vector<Triangle> simplifyAside(const Mesh& mesh, std::vector<Triangle> triangles, std::size_t wanted,
                                    const Progress& progress) {
  if (triangles.size() <= wanted) return triangles;
  static AbandonedCalls abandoned;
  abandoned.letEnd(progress);
  auto call = std::make_shared<Call>([positions = mesh.positions, all = std::move(triangles), wanted] {
    return simplify(positions, all, wanted);
  });
  std::future<std::vector<Triangle>> result = call->get_future();
  const std::weak_ptr<Call> running = call;
  std::thread([call = std::move(call)] { (*call)(); }).detach();
  while (result.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) {
    if (!progress.cancelled()) continue;
    abandoned.add(running);
    progress.throwIfCancelled();
  }
  return result.get();
}

// Marks the triangles within two rings of some vertices.
void keepAround(const Mesh& mesh, const std::vector<std::uint32_t>& vertices, std::vector<bool>& isKept) {
  std::vector<bool> isNear(mesh.positions.size(), false);
  for (const std::uint32_t v : vertices) isNear[v] = true;
  for (int ring = 0; ring < 2; ++ring) {
    std::vector<bool> next = isNear;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      if (!isNear[a] && !isNear[b] && !isNear[c]) continue;
      isKept[t] = true;
      next[a] = next[b] = next[c] = true;
    }
    isNear = std::move(next);
  }
}

}  // namespace

Mesh decimateMesh(const Mesh& mesh, std::size_t triangles, const Progress& progress) {
  constexpr int kAttempts = 12;
  if (mesh.triangles.size() <= triangles) return mesh;
  progress.update(0);
  const std::size_t defects = defectiveVertices(mesh).size();
  std::vector<bool> isKept(mesh.triangles.size(), false);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    progress.update(double(attempt) / kAttempts);
    std::vector<Triangle> kept, others;
    for (std::size_t t = 0; t < isKept.size(); ++t) (isKept[t] ? kept : others).push_back(mesh.triangles[t]);
    if (others.empty()) break;
    Mesh reduced = mesh;
    reduced.cornerUvs.clear();  // of triangles that are no more
    reduced.triangles = simplifyAside(mesh, others, triangles - std::min(triangles, kept.size()), progress);
    reduced.triangles.insert(reduced.triangles.end(), kept.begin(), kept.end());
    const std::vector<std::uint32_t> bad = defectiveVertices(reduced);
    if (bad.size() <= defects) {
      compactVertices(reduced);
      return reduced;
    }
    keepAround(mesh, bad, isKept);
  }
  return mesh;
}

}  // namespace sonoskin
