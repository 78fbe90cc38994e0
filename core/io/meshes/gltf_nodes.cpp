#include "core/io/meshes/gltf_nodes.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/base/log.h"

namespace sonoskin {
namespace {

using nlohmann::json;

constexpr int kMostDepth = 256;

// `count` finite numbers of a member, or the given ones.
std::vector<double> numbersOf(const GltfFile& file, const json& node, const char* member,
                              const std::vector<double>& otherwise) {
  if (!node.contains(member)) return otherwise;
  const auto values = node[member].get<std::vector<double>>();
  file.check(values.size() == otherwise.size());
  for (const double v : values) file.check(std::isfinite(v));
  return values;
}

glm::dmat4 transformOf(const GltfFile& file, const json& node) {
  glm::dmat4 m(1);
  if (node.contains("matrix")) {
    const auto v = numbersOf(file, node, "matrix", std::vector<double>(16));
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = v[std::size_t(i)];
    file.check(m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1);
    return m;
  }
  const auto move = numbersOf(file, node, "translation", {0, 0, 0});
  const auto turn = numbersOf(file, node, "rotation", {0, 0, 0, 1});
  const auto scale = numbersOf(file, node, "scale", {1, 1, 1});
  const glm::dquat q(turn[3], turn[0], turn[1], turn[2]);
  file.check(glm::length(q) > 0);
  m = glm::dmat4(glm::mat3_cast(glm::normalize(q)));
  for (int c = 0; c < 3; ++c) m[c] *= scale[std::size_t(c)];
  m[3] = {move[0], move[1], move[2], 1};
  return m;
}

class Placer {
 public:
  explicit Placer(const GltfFile& file) : file_(file), isPlaced_(file.count("nodes")) {
    nodes_.world.resize(isPlaced_.size(), glm::dmat4(1));
  }

  GltfNodes place() {
    std::vector<bool> isBelow(isPlaced_.size());
    for (std::size_t n = 0; n < isPlaced_.size(); ++n)
      for (const std::size_t child : childrenOf(file_.item("nodes", n), "children")) {
        file_.check(!isBelow[child]);
        isBelow[child] = true;
      }
    std::vector<std::size_t> roots;
    for (std::size_t n = 0; n < isBelow.size(); ++n)
      if (!isBelow[n]) roots.push_back(n);
    std::vector<std::size_t> shown = roots;
    if (const std::size_t scenes = file_.count("scenes"); scenes > 0) {
      shown = childrenOf(file_.item("scenes", file_.number(file_.root(), "scene", 0)), "nodes");
      if (scenes > 1)
        log(LogLevel::warning, "The glTF file holds several scenes; the one that it shows first is read.");
    }
    for (const std::size_t n : shown) placeFrom(n, glm::dmat4(1), 0);
    std::vector<std::size_t> inScene = nodes_.shown;
    for (const std::size_t n : roots)  // bones may lie outside of the scene
      if (!isPlaced_[n]) placeFrom(n, glm::dmat4(1), 0);
    nodes_.shown = std::move(inScene);
    return std::move(nodes_);
  }

 private:
  std::vector<std::size_t> childrenOf(const json& of, const char* member) const {
    std::vector<std::size_t> children;
    if (!of.contains(member)) return children;
    for (const json& child : of[member]) {
      file_.check(child.is_number_unsigned() && child.get<std::size_t>() < isPlaced_.size());
      children.push_back(child.get<std::size_t>());
    }
    return children;
  }

  void placeFrom(std::size_t n, const glm::dmat4& parent, int depth) {
    file_.check(depth < kMostDepth && !isPlaced_[n]);
    isPlaced_[n] = true;
    nodes_.shown.push_back(n);
    const json& node = file_.item("nodes", n);
    nodes_.world[n] = parent * transformOf(file_, node);
    for (const std::size_t child : childrenOf(node, "children")) placeFrom(child, nodes_.world[n], depth + 1);
  }

  const GltfFile& file_;
  std::vector<bool> isPlaced_;
  GltfNodes nodes_;
};

}  // namespace

GltfNodes placeGltfNodes(const GltfFile& file) { return Placer(file).place(); }

}  // namespace sonoskin
