#include "core/classification/slab_solver.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/classification/directions.h"
#include "core/classification/neighbour_terms.h"
#include "core/classification/pcg.h"
#include "core/classification/slab.h"

namespace sonoskin {
namespace {

constexpr double kLengthsBeyond = 8;  // coupling lengths: e^-8 of an error there is left
constexpr int kSlabPerBeyond = 6;  // slices of a slab for each beyond it: a sixth of the work is done twice

// SlabSolver: one slab after the other, in the same memory.
class SlabSolver {
 public:
  //   slices  of the largest slab
  SlabSolver(const DataSource& source, int slices, Volume<float>& u)
      : source_(source), u_(u), directions_(std::make_shared<Directions>()) {
    const std::size_t most = u.geometry.index(0, 0, slices);
    for (auto* part : {&system_.diagonal, &system_.r, &system_.p, &system_.q}) part->reserve(most);
    for (auto* part : {&directions_->x, &directions_->y, &directions_->z}) part->reserve(most);
    system_.inverse.reserve(most);
  }

  // solve: u in the slices of a slab; the slice before its first one is known.
  void solve(const Slab& slab, const Progress& progress) {
    system_.known = slab.first > 0 ? 1 : 0;
    const Slab all{slab.first - system_.known, slab.last};
    system_.u = &u_.at(0, 0, all.first);
    makeTerm(all);
    setDirections(source_.lowPassed, source_.options.directionScale, all, *directions_);
    solvePcg(neighbourTerms(directions_, source_.options), system_, source_.options.tolerance, progress);
  }

 private:
  // c, and b in the place of u.
  void makeTerm(const Slab& all) {
    const Geometry& g = source_.raw.geometry;
    const std::size_t count = g.index(0, 0, all.last - all.first);
    system_.diagonal.resize(count);
    parallelFor(all.last - all.first - system_.known, [&](std::ptrdiff_t slice) {
      const int k = system_.known + int(slice);
      for (int j = 0; j < g.dims.y; ++j) {
        const std::size_t at = g.index(0, j, k);
        dataTermRow(source_, j, all.first + k, &system_.diagonal[at], &system_.u[at]);
      }
    });
  }

  const DataSource& source_;
  Volume<float>& u_;
  std::shared_ptr<Directions> directions_;
  PcgSystem system_;
};

}  // namespace

SlabPlan planSlabs(const Geometry& geometry, const ClassificationOptions& options) {
  const double beyond = kLengthsBeyond * couplingLength(options) * double(geometry.axisScale().z);
  const int slices = geometry.dims.z;
  if (!(beyond < slices)) return {slices, 0};
  const int least = kSlabPerBeyond * std::max(1, int(std::ceil(beyond)));
  const int slabs = (slices + least - 1) / least;
  return {(slices + slabs - 1) / slabs, slabs > 1 ? int(std::ceil(beyond)) : 0};
}

Volume<float> solveInSlabs(const DataSource& source, const Progress& progress) {
  Volume<float> u = Volume<float>::unset(source.raw.geometry);
  const int slices = source.raw.geometry.dims.z;
  const SlabPlan plan = planSlabs(source.raw.geometry, source.options);
  SlabSolver solver(source, std::min(slices, 1 + plan.slices + plan.beyond), u);
  for (int first = 0; first < slices; first += plan.slices) {
    const int last = std::min(slices, first + plan.slices);
    const Progress part = progress.part(double(first) / slices, double(last) / slices);
    solver.solve({first, std::min(slices, last + plan.beyond)}, part);
  }
  progress.update(1);
  return u;
}

}  // namespace sonoskin
