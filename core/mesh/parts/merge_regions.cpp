#include "core/mesh/parts/merge_regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>

#include "core/base/disjoint_sets.h"

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr float kMostCrease = 2;  // rad: deeper places count as much as these
// What a short contact costs in the order of joining, and from which share of the root of the smaller area a contact is
// not short.
constexpr double kShortCost = 0.8, kLongShare = 2.5;

// Border: of two regions.
//   crease   the integral of the crease along it, rad mm
//   entries  of the lists of patches' neighbours: the borders of patches that it is made of, seen from one side
struct Border {
  double length = 0, crease = 0;
  std::vector<std::uint32_t> entries;

  void add(const Border& other) {
    length += other.length;
    crease += other.crease;
    entries.insert(entries.end(), other.entries.begin(), other.entries.end());
  }
};

// RegionGraph: regions that can be joined. A region's borders are listed with it by its neighbour's number.
class RegionGraph {
 public:
  RegionGraph(const PartGraph& graph, const std::vector<std::uint32_t>& regions, const MergeRules& rules,
              const std::vector<bool>& alone)
      : graph_(graph), rules_(rules), alone_(alone), from_(graph.border.size()), merged_(graph.size()) {
    for (std::size_t p = 0; p < graph.size(); ++p) areaOf(regions[p]) += double(graph.area[p]);
    for (std::uint32_t p = 0; p < graph.size(); ++p)
      for (std::uint32_t i = graph.patches.start[p]; i < graph.patches.start[p + 1]; ++i) {
        from_[i] = p;
        addBorder(regions, p, i);
      }
    version_.assign(area_.size(), 0);
    alone_.resize(area_.size(), false);
    for (std::uint32_t r = 0; r < area_.size(); ++r) offer(r, r);
  }

  // What a region has become part of.
  std::uint32_t mergedInto(std::uint32_t region) { return merged_.root(region); }

  // Joins until no border is cheap enough.
  void merge() {
    while (!queue_.empty()) {
      const Offer best = queue_.top();
      queue_.pop();
      if (!merged_.isRoot(best.a) || !merged_.isRoot(best.b)) continue;
      if (best.versions != version_[best.a] + version_[best.b]) continue;
      const Border& border = borders_[best.a].at(best.b);
      if (!mayJoin(best.a, best.b, border, contactLength(border))) continue;
      join(best.a, best.b);
    }
  }

 private:
  struct Offer {
    double cost;
    std::uint32_t a, b;  // a < b
    std::uint32_t versions;
    bool operator<(const Offer& o) const {
      return std::tie(cost, a, b) > std::tie(o.cost, o.a, o.b);  // the cheapest on top
    }
  };

  double& areaOf(std::uint32_t region) {
    if (region >= area_.size()) area_.resize(region + 1, 0), borders_.resize(region + 1);
    return area_[region];
  }

  void addBorder(const std::vector<std::uint32_t>& regions, std::uint32_t p, std::uint32_t entry) {
    const std::uint32_t q = graph_.patches.neighbours[entry];
    if (regions[p] == regions[q]) return;
    Border& border = borders_[regions[p]][regions[q]];
    const double length = double(graph_.border[entry]);
    border.length += length;
    // A crease is as narrow as a patch, and the border runs along one side of it.
    border.crease +=
        length * double(std::clamp(std::max(graph_.crease[p], graph_.crease[q]), 0.f, kMostCrease));
    border.entries.push_back(entry);
  }

  double smaller(std::uint32_t a, std::uint32_t b) const { return std::min(area_[a], area_[b]); }

  // What a contact of some length costs for being a neck, 0 to 1.
  double neck(std::uint32_t a, std::uint32_t b, double length) const {
    const double relative = 2 - 2 * length / (double(rules_.neck) * std::sqrt(smaller(a, b)));
    const double absolute = 2 - 2 * length / double(rules_.strand);
    return std::clamp(std::max(relative, absolute), 0.0, 1.0);
  }

  // Whether a person would leave two regions whole that have a contact of this length.
  bool mayJoin(std::uint32_t a, std::uint32_t b, const Border& border, double contact) const {
    const double weight = std::min(1.0, smaller(a, b) / double(rules_.smallArea));
    return (border.crease / border.length + neck(a, b, contact)) * weight <= double(rules_.crease);
  }

  // What comes first: flat borders, and long ones for their regions, so that a finger joins its hand before the cheek.
  double cost(std::uint32_t a, std::uint32_t b, const Border& border) const {
    const double share = border.length / std::sqrt(smaller(a, b));
    return border.crease / border.length + kShortCost * std::max(0.0, 1 - share / kLongShare);
  }

  // The length of the contacts that a border consists of: its patches on one side, where they touch. Many strands between
  // two regions are necks as one is: short contacts count only where there is no longer one.
  double contactLength(const Border& border) {
    std::map<std::uint32_t, double> lengths;  // by the patches of the near side
    for (const std::uint32_t e : border.entries) lengths[from_[e]] += double(graph_.border[e]);
    double longest = 0, sum = 0;
    std::vector<std::uint32_t> stack;
    while (!lengths.empty()) {
      stack.assign(1, lengths.begin()->first);
      double length = lengths.begin()->second;
      lengths.erase(lengths.begin());
      while (!stack.empty()) {
        const std::uint32_t p = stack.back();
        stack.pop_back();
        for (std::uint32_t i = graph_.patches.start[p]; i < graph_.patches.start[p + 1]; ++i)
          if (const auto other = lengths.find(graph_.patches.neighbours[i]); other != lengths.end()) {
            length += other->second;
            stack.push_back(other->first);
            lengths.erase(other);
          }
      }
      longest = std::max(longest, length);
      if (length >= double(rules_.strand)) sum += length;
    }
    return std::max(longest, sum);
  }

  // Puts the borders of a region into the queue: those to later regions than `from`.
  void offer(std::uint32_t a, std::uint32_t from) {
    for (const auto& [b, border] : borders_[a]) {
      if (b < from || alone_[a] || alone_[b]) continue;
      if (!mayJoin(a, b, border, border.length)) continue;
      queue_.push({cost(a, b, border), std::min(a, b), std::max(a, b), version_[a] + version_[b]});
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    if (borders_[a].size() < borders_[b].size()) std::swap(a, b);  // the longer list stays
    merged_.joinInto(b, a);
    area_[a] += area_[b];
    borders_[a].erase(b);
    for (const auto& [c, border] : borders_[b]) {
      if (c == a) continue;
      const Border back = std::move(borders_[c].at(b));
      borders_[c].erase(b);
      borders_[a][c].add(border);
      borders_[c][a].add(back);
    }
    borders_[b].clear();
    ++version_[a];
    offer(a, 0);
  }

  const PartGraph& graph_;
  MergeRules rules_;
  std::vector<bool> alone_;
  std::vector<std::uint32_t> from_;  // per entry of the lists of neighbours: whose it is
  std::vector<double> area_;
  std::vector<std::map<std::uint32_t, Border>> borders_;
  std::vector<std::uint32_t> version_;
  DisjointSets merged_;
  std::priority_queue<Offer> queue_;
};

}  // namespace

std::vector<std::uint32_t> mergeRegions(const PartGraph& graph, std::vector<std::uint32_t> regions,
                                        const MergeRules& rules, const std::vector<bool>& alone) {
  if (regions.empty()) return regions;
  RegionGraph merged(graph, regions, rules, alone);
  merged.merge();
  std::vector<std::uint32_t> number(graph.size(), kNone);
  std::uint32_t count = 0;
  for (std::uint32_t& region : regions) {
    std::uint32_t& n = number[merged.mergedInto(region)];
    if (n == kNone) n = count++;
    region = n;
  }
  return regions;
}

}  // namespace sonoskin
