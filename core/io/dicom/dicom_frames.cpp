#include "core/io/dicom/dicom_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

// Three numbers; none of a body is as far away as a kilometre.
std::optional<glm::dvec3> vector(const DicomItem& item, DicomTag tag, std::size_t from = 0) {
  constexpr double kFarthest = 1e6;
  const std::vector<double> n = item.numbers(tag);
  if (n.size() < from + 3) return {};
  for (std::size_t c = from; c < from + 3; ++c)
    if (std::abs(n[c]) > kFarthest) return {};
  return glm::dvec3(n[from], n[from + 1], n[from + 2]);
}

void setOrientation(DicomFrame& frame, const DicomItem& item, DicomTag tag) {
  const auto row = vector(item, tag), column = vector(item, tag, 3);
  if (!row || !column) return;
  const double x = glm::length(*row), y = glm::length(*column);
  // Directions that are none; what is at no right angle is refused later.
  if (!(std::abs(x - 1) < 0.01) || !(std::abs(y - 1) < 0.01)) return;
  frame.row = *row / x, frame.column = *column / y, frame.hasOrientation = true;
}

void setMark(DicomFrame& frame, DicomMark mark, const std::optional<double>& value) {
  if (value) frame.marks[std::size_t(mark)] = *value;
}

// A word as a number, for telling apart.
std::optional<double> mixed(const std::string& word) {
  if (word.empty()) return {};
  return double(std::hash<std::string>{}(word) % 1'000'000'007);
}

DicomScale scaleOf(const DicomItem& item) {
  const auto slope = item.number(tag::kSlope), intercept = item.number(tag::kIntercept);
  return {slope.value_or(1), intercept.value_or(0), slope || intercept};
}

std::optional<double> firstOf(const DicomItem& item, std::initializer_list<DicomTag> tags) {
  for (const DicomTag tag : tags)
    if (const auto found = item.number(tag)) return found;
  return {};
}

// What a file tells of all of its frames.
DicomFrame common(const DicomItem& root, const DicomPixels& p, const DicomSpacing& spacing) {
  DicomFrame frame;
  const DicomItem* detector = root.item(tag::kDetectors);  // where nuclear medicine has them
  const DicomItem& place = detector && !root.find(tag::kPosition) ? *detector : root;
  frame.position = vector(place, tag::kPosition);
  setOrientation(frame, place, tag::kOrientation);
  frame.size = {p.columns, p.rows};
  frame.spacing = spacing.mm, frame.spacingKnown = spacing.known;
  frame.slices = std::abs(root.number(tag::kSliceSpacing).value_or(0));
  frame.scale = scaleOf(root);
  setMark(frame, DicomMark::kind, mixed(root.text(tag::kImageType)));
  setMark(frame, DicomMark::echo, firstOf(root, {tag::kEchoTime, tag::kEchoNumber}));
  setMark(frame, DicomMark::diffusion, root.number(tag::kDiffusionB));
  setMark(frame, DicomMark::temporal, root.number(tag::kTemporal));
  setMark(frame, DicomMark::acquisition, root.number(tag::kAcquisition));
  setMark(frame, DicomMark::trigger, root.number(tag::kTriggerTime));
  setMark(frame, DicomMark::time, root.number(tag::kAcquisitionTime));
  setMark(frame, DicomMark::content, root.number(tag::kContentTime));
  const std::string group =
      fmt::format("{} {} {} {} {} {} {} {} {:.5g} {:.5g}", root.text(tag::kSeries), p.columns, p.rows,
                  p.samples, p.allocated, p.isSigned, int(p.colour), p.isFloat, spacing.mm.x, spacing.mm.y);
  frame.group = std::hash<std::string>{}(group);
  return frame;
}

// Groups: the functional groups of a frame, its own before those of all.
struct Groups {
  const DicomItem* own;
  const DicomItem* shared;
  const DicomItem* find(DicomTag sequence) const {
    const DicomItem* found = own ? own->item(sequence) : nullptr;
    return found || !shared ? found : shared->item(sequence);
  }
};

// The volume's own frame before the patient's, as its apex is in that one.
void place(DicomFrame& frame, const Groups& groups) {
  const auto position = [&](DicomTag sequence, DicomTag tag) {
    const DicomItem* item = groups.find(sequence);
    return item ? vector(*item, tag) : std::nullopt;
  };
  frame.position = position(tag::kVolumePlanePosition, tag::kVolumePosition);
  const bool ofVolume = frame.position.has_value();
  if (!ofVolume) frame.position = position(tag::kPlanePosition, tag::kPosition);
  frame.hasOrientation = false;
  frame.marks[std::size_t(DicomMark::time)] = std::numeric_limits<double>::quiet_NaN();  // that of all
  if (const DicomItem* item = groups.find(ofVolume ? tag::kVolumePlaneOrientation : tag::kPlaneOrientation))
    setOrientation(frame, *item, ofVolume ? tag::kVolumeOrientation : tag::kOrientation);
  if (const DicomItem* measures = groups.find(tag::kPixelMeasures)) {
    if (const auto mm = pixelSpacing(*measures, tag::kPixelSpacing))
      frame.spacing = *mm, frame.spacingKnown = true;
    if (const auto mm = measures->number(tag::kSliceSpacing)) frame.slices = std::abs(*mm);
  }
}

void mark(DicomFrame& frame, const Groups& groups) {
  const auto number = [&](DicomTag sequence, DicomTag tag) {
    const DicomItem* item = groups.find(sequence);
    return item ? item->number(tag) : std::nullopt;
  };
  setMark(frame, DicomMark::echo, number(tag::kMrEcho, tag::kEffectiveEcho));
  setMark(frame, DicomMark::diffusion, number(tag::kMrDiffusion, tag::kDiffusionB));
  setMark(frame, DicomMark::temporal, number(tag::kFrameContent, tag::kTemporalIndex));
  setMark(frame, DicomMark::temporal, number(tag::kTemporalPosition, tag::kTemporalOffset));
  setMark(frame, DicomMark::acquisition, number(tag::kFrameContent, tag::kFrameAcquisition));
  setMark(frame, DicomMark::trigger, number(tag::kCardiacSync, tag::kTriggerDelay));
  setMark(frame, DicomMark::time, number(tag::kFrameContent, tag::kFrameReference));
  setMark(frame, DicomMark::time, number(tag::kFrameContent, tag::kFrameAcquired));
  for (const DicomTag sequence : {tag::kMrFrameType, tag::kCtFrameType})
    if (const DicomItem* item = groups.find(sequence))
      setMark(frame, DicomMark::kind, mixed(item->text(tag::kFrameType)));
}

// The dimensions that a file counts its frames by, but for those of space [DICOM PS3.3, C.7.6.17].
struct Dimensions {
  std::vector<DicomTag> pointers;

  explicit Dimensions(const DicomItem& root) {
    for (const DicomItem& dimension : root.items(tag::kDimensions)) {
      const std::vector<double> to = dimension.numbers(tag::kDimensionPointer);  // group, element
      pointers.push_back(to.size() < 2 ? 0 : DicomTag(to[0]) << 16 | DicomTag(to[1]));
    }
  }
  // Where the frame does not tell the thing itself, its number in the dimension tells as much.
  void mark(DicomFrame& frame, const DicomItem& content) const {
    const std::vector<double> values = content.numbers(tag::kDimensionValues);
    for (std::size_t d = 0; d < std::min(values.size(), pointers.size()); ++d) {
      const auto m = markOf(pointers[d]);
      if (m && std::isnan(frame.mark(*m))) setMark(frame, *m, values[d]);
    }
  }

 private:
  static std::optional<DicomMark> markOf(DicomTag pointer) {
    switch (pointer) {
      case tag::kPosition:
      case tag::kVolumePosition:
      case tag::kStack:
      case tag::kInStackPosition:
        return {};
      case tag::kDataType:
        return DicomMark::kind;
      case tag::kEffectiveEcho:
        return DicomMark::echo;
      case tag::kDiffusionB:
        return DicomMark::diffusion;
      default:
        return DicomMark::temporal;
    }
  }
};

}  // namespace

bool hasFrameGroups(const DicomItem& root) {
  return root.find(tag::kFrameGroups) || root.find(tag::kSharedGroups);
}

std::vector<DicomFrame> framesOf(const DicomItem& root, const DicomPixels& pixels,
                                 const DicomSpacing& spacing) {
  std::vector<DicomFrame> frames(std::size_t(pixels.frames), common(root, pixels, spacing));
  const auto& own = root.items(tag::kFrameGroups);
  const Dimensions dimensions(root);
  const bool isInOrder = root.text(tag::kOrganisation) == "3D_TEMPORAL";
  for (std::size_t f = 0; f < frames.size(); ++f) {
    DicomFrame& frame = frames[f];
    frame.index = int(f);
    if (!hasFrameGroups(root)) continue;
    const Groups groups{f < own.size() ? &own[f] : nullptr, root.item(tag::kSharedGroups)};
    place(frame, groups);
    mark(frame, groups);
    if (const DicomItem* transform = groups.find(tag::kPixelTransform)) frame.scale = scaleOf(*transform);
    const DicomItem* content = groups.find(tag::kFrameContent);
    const DicomItem* data = groups.find(tag::kImageDataType);
    if (content) dimensions.mark(frame, *content);
    if (isInOrder && std::isnan(frame.mark(DicomMark::time))) setMark(frame, DicomMark::time, double(f));
    const std::string type = data ? data->text(tag::kDataType) : "";
    frame.isTissue = type.empty() || type == "TISSUE_INTENSITY";
    frame.group = std::hash<std::string>{}(fmt::format("{} {} {} {:.5g} {:.5g}", frame.group,
                                                       content ? content->text(tag::kStack) : "", type,
                                                       frame.spacing.x, frame.spacing.y));
  }
  return frames;
}

}  // namespace sonoskin
