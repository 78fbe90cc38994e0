#include "core/pipeline/check_ranges.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace sonoskin {
namespace {

template <class T>
void check(const Group& group, const Field& field, T value, const Range<T>& range) {
  if (value >= range.min && value <= range.max) return;  // NaN fails both
  throw Error(fmt::format("{}.{} is {}: it must lie between {} and {}", group.name, field.name, value,
                          range.min, range.max),
              Error::Kind::usage);
}

struct RangeVisitor {
  template <class T>
  void operator()(const Group& group, const Field& field, const T& value, const Range<T>& range) const {
    check(group, field, value, range);
  }
  template <class T>
  void operator()(const Group& group, const Field& field, const std::array<T, 3>& values,
                  const Range<T>& range) const {
    for (const T value : values) check(group, field, value, range);
  }
  template <class T>
  void operator()(const Group& group, const Field& field, const Places& places, const Range<T>& range) const {
    for (const auto& place : places) (*this)(group, field, place, range);
  }
  template <class T>
  void operator()(const Group&, const Field&, const T&) const {}  // flags and choices have no range
};

}  // namespace

void checkRanges(const Parameters& parameters) {
  forEachField(RangeVisitor{}, parameters);
  if (parameters.mesh.partsCut.size() % 3 != 0)
    throw Error(fmt::format("mesh.partsCut has {} places: a stroke has three, its begin, its end and the eye",
                            parameters.mesh.partsCut.size()),
                Error::Kind::usage);
}

namespace {

struct Clamping {
  template <class T>
  void operator()(const Group&, const Field&, T& value, const Range<T>& range) const {
    value = value >= range.min ? std::min(value, range.max) : range.min;
  }
  template <class T>
  void operator()(const Group& group, const Field& field, std::array<T, 3>& values,
                  const Range<T>& range) const {
    for (T& value : values) (*this)(group, field, value, range);
  }
  template <class T>
  void operator()(const Group& group, const Field& field, Places& places, const Range<T>& range) const {
    for (auto& place : places) (*this)(group, field, place, range);
  }
  template <class T>
  void operator()(const Group&, const Field&, T&) const {}
};

}  // namespace

Parameters withinRanges(Parameters parameters) {
  forEachField(Clamping{}, parameters);
  Places& cut = parameters.mesh.partsCut;
  cut.resize(cut.size() - cut.size() % 3);
  return parameters;
}

}  // namespace sonoskin
