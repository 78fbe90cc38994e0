// NRRD headers (teem.sourceforge.net/nrrd/format.html).
#include <array>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/stored_volume.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

struct Nrrd {
  HeaderKeys fields, keys;  // "field: value" with the name in small letters, and "key:=value"
  std::size_t bytes = 0;    // of the header, with the empty line that ends it
  bool ended = false;       // by an empty line
};

Nrrd parse(std::string_view text) {
  Nrrd nrrd;
  HeaderLines lines(text);
  lines.next();  // the magic
  while (const auto line = lines.next()) {
    nrrd.bytes = lines.position();
    if (line->empty()) {
      nrrd.ended = true;
      return nrrd;
    }
    if (line->starts_with('#')) continue;
    const std::size_t colon = line->find(':');
    if (colon == std::string_view::npos) continue;
    if (line->substr(colon).starts_with(":="))
      nrrd.keys[std::string(trimmed(line->substr(0, colon)))] = line->substr(colon + 2);
    else
      nrrd.fields[lowerCase(trimmed(line->substr(0, colon)))] = trimmed(line->substr(colon + 1));
  }
  return nrrd;
}

std::string_view field(const Nrrd& nrrd, std::string_view name) {
  const auto found = nrrd.fields.find(name);
  return found == nrrd.fields.end() ? std::string_view{} : std::string_view(found->second);
}

std::optional<NumberType> typeOf(std::string_view name) {
  static const std::map<std::string_view, NumberType> types{
      {"signed char", NumberType::int8},    {"int8", NumberType::int8},
      {"int8_t", NumberType::int8},         {"uchar", NumberType::uint8},
      {"unsigned char", NumberType::uint8}, {"uint8", NumberType::uint8},
      {"uint8_t", NumberType::uint8},       {"short", NumberType::int16},
      {"short int", NumberType::int16},     {"signed short", NumberType::int16},
      {"int16", NumberType::int16},         {"int16_t", NumberType::int16},
      {"ushort", NumberType::uint16},       {"unsigned short", NumberType::uint16},
      {"uint16", NumberType::uint16},       {"uint16_t", NumberType::uint16},
      {"int", NumberType::int32},           {"signed int", NumberType::int32},
      {"int32", NumberType::int32},         {"int32_t", NumberType::int32},
      {"uint", NumberType::uint32},         {"unsigned int", NumberType::uint32},
      {"uint32", NumberType::uint32},       {"uint32_t", NumberType::uint32},
      {"longlong", NumberType::int64},      {"long long", NumberType::int64},
      {"int64", NumberType::int64},         {"int64_t", NumberType::int64},
      {"ulonglong", NumberType::uint64},    {"unsigned long long", NumberType::uint64},
      {"uint64", NumberType::uint64},       {"uint64_t", NumberType::uint64},
      {"float", NumberType::float32},       {"double", NumberType::float64}};
  const auto found = types.find(name);
  if (found == types.end()) return {};
  return found->second;
}

// "(a,b,c)" gives the vector, "none" NaN; anything else ends the list.
std::vector<glm::dvec3> vectors(std::string_view text) {
  std::vector<glm::dvec3> found;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    if (text.starts_with("none")) {
      found.emplace_back(std::numeric_limits<double>::quiet_NaN());
      text.remove_prefix(4);
      continue;
    }
    const std::size_t close = text.find(')');
    if (!text.starts_with('(') || close == std::string_view::npos) return {};
    std::string inside(text.substr(1, close - 1));
    for (char& c : inside)
      if (c == ',') c = ' ';
    const auto v = parseNumbers<double>(inside);
    if (!v || v->size() != 3) return {};
    found.emplace_back((*v)[0], (*v)[1], (*v)[2]);
    text.remove_prefix(close + 1);
  }
  return found;
}

// What turns the header's world into LPS.
glm::dvec3 toLps(std::string_view space) {
  const std::string name = lowerCase(space);
  if (name == "right-anterior-superior" || name == "ras") return {-1, -1, 1};
  if (name == "left-anterior-superior" || name == "las") return {1, -1, 1};
  return {1, 1, 1};
}

// The axis that is not one of space in a file of four: the one said to have no direction or to be of another
// kind.
std::size_t oddAxis(const Nrrd& nrrd, const std::vector<glm::dvec3>& directions,
                    const std::vector<std::int64_t>& sizes) {
  for (std::size_t a = 0; a < directions.size(); ++a)
    if (std::isnan(directions[a].x)) return a;
  const auto kinds = words(field(nrrd, "kinds"));
  for (std::size_t a = 0; a < std::min<std::size_t>(kinds.size(), 4); ++a)
    if (kinds[a] != "domain" && kinds[a] != "space" && kinds[a] != "???" && kinds[a] != "none") return a;
  return sizes[0] <= 4 ? 0 : 3;
}

void placeData(const Nrrd& nrrd, const fs::path& path, StoredVolume& stored) {
  std::string_view file = field(nrrd, "data file");
  if (file.empty()) file = field(nrrd, "datafile");
  require(file.empty() || (!lowerCase(file).starts_with("list") && file.find('%') == std::string_view::npos),
          "{} spreads its data over several files; save it as one .nrrd file.", path.string());
  require(!file.empty() || nrrd.ended, "{} ends within its header; get a fresh copy.", path.string());
  stored.dataFile = file.empty() ? path : besideHeader(path, file);
  stored.fileOffset = file.empty() ? nrrd.bytes : 0;

  const std::string encoding = lowerCase(field(nrrd, "encoding"));
  if (encoding == "raw")
    stored.encoding = Encoding::raw;
  else if (encoding == "gzip" || encoding == "gz")
    stored.encoding = Encoding::deflate;
  else if (encoding == "txt" || encoding == "text" || encoding == "ascii")
    stored.encoding = Encoding::text;
  else
    throw Error(
        fmt::format("{} is packed in the way \"{}\", which is not known here; save it with gzip or raw.",
                    path.string(), encoding.substr(0, 20)));
  require(field(nrrd, "line skip").empty() || field(nrrd, "line skip") == "0",
          "{} skips lines before its data; save it again without.", path.string());
  if (const std::string_view skip = field(nrrd, "byte skip"); !skip.empty()) {
    const auto bytes = parseNumber<std::int64_t>(skip);
    require(bytes && *bytes >= 0, "{} has a byte skip that is not known here; save it again without.",
            path.string());
    (stored.encoding == Encoding::deflate ? stored.streamOffset : stored.fileOffset) +=
        std::uintmax_t(*bytes);
  }
  stored.bigEndian = lowerCase(field(nrrd, "endian")) == "big";
}

void placeInWorld(const Nrrd& nrrd, std::vector<glm::dvec3> directions, std::size_t firstAxis,
                  StoredVolume& stored) {
  Geometry& g = stored.geometry;
  const glm::dvec3 lps = toLps(field(nrrd, "space"));
  if (const auto origin = vectors(field(nrrd, "space origin")); !origin.empty()) g.origin = lps * origin[0];
  if (directions.size() >= firstAxis + 3) {
    for (int a = 0; a < 3; ++a) {
      const glm::dvec3 step = lps * directions[firstAxis + std::size_t(a)];
      // An axis of time or of frames in the place of a third one of space has no length.
      if (std::isnan(step.x)) {
        stored.spacingKnown = false;
        g.direction[a] = glm::cross(g.direction[(a + 1) % 3], g.direction[(a + 2) % 3]);
        continue;
      }
      g.spacing[a] = glm::length(step);
      g.direction[a] = step / g.spacing[a];
    }
    return;
  }
  const auto spacings = parseNumbers<double>(field(nrrd, "spacings"));
  stored.spacingKnown = spacings && spacings->size() >= firstAxis + 3;
  for (int a = 0; a < 3 && stored.spacingKnown; ++a) g.spacing[a] = (*spacings)[firstAxis + std::size_t(a)];
}

// The sizes of three or four axes.
std::vector<std::int64_t> sizesOf(const Nrrd& nrrd, const fs::path& path) {
  const auto dimension = parseNumber<int>(field(nrrd, "dimension"));
  require(dimension && *dimension >= 1 && *dimension <= 16,
          "{} does not say how many dimensions it has; get a fresh copy.", path.string());
  require(*dimension == 3 || *dimension == 4, "{} has {} dimensions; a volume has 3, or 4 with time.",
          path.string(), *dimension);
  const auto sizes = parseNumbers<std::int64_t>(field(nrrd, "sizes"));
  require(sizes && sizes->size() == std::size_t(*dimension),
          "The sizes in {} are not {} numbers; get a fresh copy.", path.string(), *dimension);
  for (const std::int64_t size : *sizes)
    require(size >= 1 && size <= 65535,
            "{} says that it has {} voxels along one axis; 2 to 65535 are possible.", path.string(), size);
  return *sizes;
}

std::vector<glm::dvec3> directionsOf(const Nrrd& nrrd, std::size_t axes, const fs::path& path) {
  const std::string_view text = field(nrrd, "space directions");
  const std::vector<glm::dvec3> directions = vectors(text);
  require(directions.empty() ? text.empty() : directions.size() == axes,
          "The space directions in {} are not {} vectors of three numbers; get a fresh copy.", path.string(),
          axes);
  return directions;
}

// Takes the axis that is not one of space as time or components. Returns the first axis of space.
std::size_t takeOddAxis(const Nrrd& nrrd, std::size_t odd, const std::vector<std::int64_t>& sizes,
                        StoredVolume& stored) {
  if (odd == 3) {
    stored.timeSteps = int(sizes[3]);
    return 0;
  }
  stored.components = int(sizes[0]);
  const auto kinds = words(field(nrrd, "kinds"));
  stored.timeIsFastest = !kinds.empty() && (kinds[0] == "list" || kinds[0] == "time");
  return 1;
}

}  // namespace

StoredVolume readNrrdHeader(const fs::path& path) {
  const std::string text = readHeaderText(path);
  const Nrrd nrrd = parse(text);
  const std::vector<std::int64_t> sizes = sizesOf(nrrd, path);
  const std::vector<glm::dvec3> directions = directionsOf(nrrd, sizes.size(), path);
  StoredVolume stored;
  stored.format = "NRRD";
  const auto type = typeOf(lowerCase(field(nrrd, "type")));
  require(type.has_value(), "{} has numbers of the type \"{}\", which is not known here.", path.string(),
          field(nrrd, "type").substr(0, 20));
  stored.type = *type;

  std::size_t firstAxis = 0;
  if (sizes.size() == 4) {
    const std::size_t odd = oddAxis(nrrd, directions, sizes);
    require(odd == 0 || odd == 3,
            "{} has its time axis between the axes of space; save it with time first or last.",
            path.string());
    firstAxis = takeOddAxis(nrrd, odd, sizes, stored);
  }
  for (int a = 0; a < 3; ++a) stored.geometry.dims[a] = int(sizes[firstAxis + std::size_t(a)]);
  placeInWorld(nrrd, directions, firstAxis, stored);
  placeData(nrrd, path, stored);
  stored.beam = beamFromKeys(nrrd.keys);
  stored.unitRange = rangeFromKeys(nrrd.keys);
  return stored;
}

}  // namespace sonoskin
