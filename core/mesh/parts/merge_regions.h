#pragma once

#include "core/mesh/parts/part_graph.h"

namespace sonoskin {

// MergeRules: when two regions of a surface are one part. Contacts between them that are longer than a strand's girth
// count together, shorter ones by themselves: many strands are necks as one is.
//   crease      rad: a person would cut along a border that is hollower than this in the mean. On real faces nose,
//               lips and lids mostly lie below 0.6, arms and cheeks above 0.85
//   neck        a contact shorter than this share of the root of the smaller region's area is a neck, and costs up to 1 rad
//   strand      mm: so is one shorter than this, the girth of a strand about 4 mm thick
//   smallArea   mm²: regions smaller than this are no parts of their own
struct MergeRules {
  float crease = 0.72f;
  float neck = 1.1f;
  float strand = 14;
  float smallArea = 60;
};

// mergeRegions: joins regions that no crease and no neck parts, the most alike first.
//   regions  per patch, numbered from 0 without gaps
//   alone    per region: whether it stays by itself; may be shorter
//   output   per patch, numbered from 0 in the order of their first patches
//   method   region adjacency graph and a queue of its borders, flat and long ones first; sums along borders are kept while
//            regions grow [hierarchical merging of watershed basins: Mangan and Whitaker 1999; necks are ours]
//   cost     O(n log n); 10000 patches in 0.01 s
std::vector<std::uint32_t> mergeRegions(const PartGraph& graph, std::vector<std::uint32_t> regions,
                                        const MergeRules& rules, const std::vector<bool>& alone = {});

}  // namespace sonoskin
