#include "core/io/dicom/dicom_stacks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/io/dicom/dicom_places.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Frames = std::vector<DicomFrame>;

// Frames by a property, each part in the order of the frames, the parts in that of their first one.
template <class Property>
std::vector<Frames> partsBy(const Frames& frames, const Property& property) {
  std::vector<Frames> parts;
  std::map<decltype(property(frames.front())), std::size_t> known;
  for (const DicomFrame& frame : frames) {
    const auto [found, isNew] = known.try_emplace(property(frame), parts.size());
    if (isNew) parts.emplace_back();
    parts[found->second].push_back(frame);
  }
  return parts;
}

bool parallel(const DicomFrame& a, const DicomFrame& b) {
  constexpr double kTurn = 1e-3;  // radians: a quarter of a millimetre over a hand's breadth
  return glm::length(a.row - b.row) <= kTurn && glm::length(a.column - b.column) <= kTurn;
}

std::vector<Frames> byOrientation(const Frames& frames) {
  std::vector<Frames> parts;
  for (const DicomFrame& frame : frames) {
    // The last one first: files mostly come in their order.
    const auto part = std::find_if(parts.rbegin(), parts.rend(),
                                   [&](const Frames& p) { return parallel(p.front(), frame); });
    if (part != parts.rend())
      part->push_back(frame);
    else
      parts.push_back({frame});
  }
  return parts;
}

double degreesBetween(const DicomFrame& a, const DicomFrame& b) {
  const glm::dvec3 n = a.normal(), m = b.normal();
  const double turn = std::atan2(glm::length(glm::cross(n, m)), glm::dot(n, m));
  const double spin = std::acos(std::clamp(glm::dot(a.row, b.row), -1.0, 1.0));
  return glm::degrees(std::max(turn, spin));
}

// A few planes across each other, to find one's way by, are no series that turns.
bool turns(const std::vector<Frames>& parts, std::size_t frames) {
  constexpr std::size_t kFewPlanes = 3;
  return parts.size() > kFewPlanes && 2 * parts.size() > frames;
}

class Stacker {
 public:
  explicit Stacker(const fs::path& path) : path_(path) {}

  std::vector<DicomVolume> stack(const Frames& frames) {
    std::vector<DicomVolume> volumes;
    for (const Frames& group : partsBy(frames, [](const DicomFrame& f) { return f.group; }))
      addGroup(group, volumes);
    return volumes;
  }

 private:
  DicomVolume plain(const Frames& frames, int slices) const {
    DicomVolume volume;
    volume.frames = frames;
    volume.file = frames.front().file;
    volume.isTissue = frames.front().isTissue;
    volume.geometry.dims = {frames.front().size, slices};
    volume.geometry.spacing = {frames.front().spacing, 1};
    return volume;
  }
  DicomVolume refused(const Frames& frames, const Error& why) const {
    DicomVolume volume = plain(frames, int(std::min<std::size_t>(frames.size(), 65535)));
    volume.refusal = why;
    return volume;
  }

  void addGroup(const Frames& group, std::vector<DicomVolume>& volumes) const {
    Frames placed;
    std::ranges::copy_if(group, std::back_inserter(placed),
                         [](const DicomFrame& f) { return f.position.has_value(); });
    if (placed.empty()) {
      volumes.push_back(plain(group, 1));  // pictures, unless somebody wants them as a volume
      if (group.size() > 1) volumes.back().refusal = unplaced(group.size());
      return;
    }
    const std::size_t first = volumes.size();
    const std::vector<Frames> parts = byOrientation(placed);
    if (turns(parts, placed.size()))
      volumes.push_back(refused(placed, turning(parts)));
    else
      for (const Frames& part : parts) addParallel(part, volumes);
    if (const std::size_t lost = group.size() - placed.size(); lost > 0)
      volumes[first].warnings.push_back(fmt::format(
          "{} of the series' {} slices {} left out: nothing says where {} {}.", lost, group.size(),
          lost > 1 ? "are" : "is", lost > 1 ? "they" : "it", lost > 1 ? "lie" : "lies"));
    if (!placed.front().hasOrientation)
      volumes[first].warnings.push_back(
          "The series does not say how its slices are turned; they are taken to lie across the body.");
  }

  Error unplaced(std::size_t slices) const {
    return Error(
        fmt::format("The {} slices in {} do not say where they lie (Image Position), so that their order and "
                    "distance are unknown; export the series again, or as NRRD.",
                    slices, path_.string()));
  }
  Error turning(const std::vector<Frames>& parts) const {
    double least = 360;
    for (std::size_t part = 1; part < parts.size(); ++part)
      least = std::min(least, degreesBetween(parts[0].front(), parts[part].front()));
    return Error(
        fmt::format("The slices of the series in {} turn against each other, by {:.1f} degrees from one to "
                    "the next, and make no straight volume; export it as a volume that is resampled.",
                    path_.string(), least));
  }

  static bool isUnique(const std::vector<DicomPlace>& places) {
    return std::ranges::all_of(places, [](const DicomPlace& p) { return p.frames.size() == 1; });
  }
  // Whether frames at one place differ in a mark.
  static bool tellsApart(const std::vector<DicomPlace>& places, DicomMark mark) {
    return std::ranges::any_of(places, [&](const DicomPlace& p) {
      return std::ranges::any_of(p.frames, [&](const DicomFrame* f) {
        return f->mark(mark) != p.frames.front()->mark(mark) && !std::isnan(f->mark(mark));
      });
    });
  }
  static std::vector<Frames> byMark(const Frames& frames, DicomMark mark) {
    auto parts = partsBy(frames, [&](const DicomFrame& f) {
      return std::isnan(f.mark(mark)) ? std::numeric_limits<double>::lowest() : f.mark(mark);
    });
    std::ranges::stable_sort(parts, {}, [&](const Frames& part) {
      return std::isnan(part.front().mark(mark)) ? std::numeric_limits<double>::lowest()
                                                 : part.front().mark(mark);
    });
    return parts;
  }

  void addParallel(const Frames& frames, std::vector<DicomVolume>& volumes) const {
    const std::vector<DicomPlace> places = placesOf(frames);
    if (isUnique(places)) {
      volumes.push_back(stacked(places));
      return;
    }
    for (const DicomMark mark : {DicomMark::kind, DicomMark::echo, DicomMark::diffusion})
      if (tellsApart(places, mark)) {
        for (const Frames& part : byMark(frames, mark)) addParallel(part, volumes);
        return;
      }
    for (const DicomMark mark : {DicomMark::temporal, DicomMark::acquisition, DicomMark::trigger})
      if (tellsApart(places, mark) && addSteps(byMark(frames, mark), mark, volumes)) return;
    for (const DicomMark mark : {DicomMark::time, DicomMark::content})
      if (addByTime(places, mark, volumes)) return;
    volumes.push_back(refused(frames, doubled(places)));
  }

  DicomVolume stacked(const std::vector<DicomPlace>& places) const {
    Frames frames;
    for (const DicomPlace& place : places) frames.push_back(*place.frames.front());
    DicomVolume volume = plain(frames, int(std::min<std::size_t>(frames.size(), 1u << 20)));
    if (places.size() > 1) setPlaces(volume, places, path_);
    return volume;
  }

  // Parts of other times: time steps where all are at the same places, else volumes of their own.
  bool addSteps(const std::vector<Frames>& parts, DicomMark mark, std::vector<DicomVolume>& volumes) const {
    std::vector<DicomVolume> steps;
    bool same = true;
    for (const Frames& part : parts) {
      const std::vector<DicomPlace> places = placesOf(part);
      if (!isUnique(places)) return false;
      steps.push_back(stacked(places));
      same = same && liesAs(steps.back(), steps.front());
    }
    if (!same) {
      std::ranges::move(steps, std::back_inserter(volumes));
      return true;
    }
    DicomVolume& all = steps.front();
    all.timeSteps = int(steps.size());
    all.stepSeconds = secondsBetween(steps, mark);
    for (std::size_t s = 1; s < steps.size(); ++s) {
      std::ranges::copy(steps[s].frames, std::back_inserter(all.frames));
      addNew(steps[s].warnings, all.warnings);
    }
    volumes.push_back(std::move(all));
    return true;
  }
  // Slice by slice, as those of one step may lie unevenly where those of another do not.
  static bool liesAs(const DicomVolume& a, const DicomVolume& b) {
    const double near = 0.1 * b.geometry.minSpacing();
    const auto isNear = [&](const DicomFrame& f, const DicomFrame& g) {
      return glm::length(*f.position - *g.position) <= near;
    };
    return a.refusal.has_value() == b.refusal.has_value() && std::ranges::equal(a.frames, b.frames, isNear);
  }
  static void addNew(const std::vector<std::string>& warnings, std::vector<std::string>& to) {
    for (const std::string& warning : warnings)
      if (std::ranges::find(to, warning) == to.end()) to.push_back(warning);
  }
  // Triggers are in milliseconds. Of all other marks nobody knows the unit here: the same one may be a time or a count.
  static double secondsBetween(const std::vector<DicomVolume>& steps, DicomMark mark) {
    const double first = steps[0].frames[0].mark(mark), last = steps.back().frames[0].mark(mark);
    const double each = (last - first) / double(steps.size() - 1) / 1000;
    return mark == DicomMark::trigger && each > 0 && std::isfinite(each) ? each : 0;
  }

  // The n-th of each place in time is of the n-th step.
  bool addByTime(std::vector<DicomPlace> places, DicomMark mark, std::vector<DicomVolume>& volumes) const {
    const std::size_t steps = places.front().frames.size();
    const auto time = [&](const DicomFrame* f) { return f->mark(mark); };
    for (DicomPlace& place : places) {
      std::ranges::stable_sort(place.frames, {}, time);
      const bool differ = place.frames.size() == steps && !std::isnan(time(place.frames.front())) &&
                          std::ranges::adjacent_find(place.frames, {}, time) == place.frames.end();
      if (!differ) return false;
    }
    std::vector<Frames> parts(steps);
    for (std::size_t s = 0; s < steps; ++s)
      for (const DicomPlace& place : places) parts[s].push_back(*place.frames[s]);
    return addSteps(parts, mark, volumes);
  }

  Error doubled(const std::vector<DicomPlace>& places) const {
    std::size_t most = 0, several = 0;
    for (const DicomPlace& place : places) {
      most = std::max(most, place.frames.size());
      several += place.frames.size() > 1;
    }
    return Error(
        fmt::format("The series in {} has up to {} slices at the same place, at {} of its {} places, and "
                    "nothing in them says which belong together; keep one volume per folder.",
                    path_.string(), most, several, places.size()));
  }

  const fs::path& path_;
};

}  // namespace

std::vector<DicomVolume> stacksOf(const Frames& frames, const fs::path& path) {
  return Stacker(path).stack(frames);
}

}  // namespace sonoskin
