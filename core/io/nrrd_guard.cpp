// NRRD headers (teem.sourceforge.net/nrrd/format.html).
#include <algorithm>

#include "core/base/error.h"
#include "core/io/declared_data.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

struct Nrrd {
  HeaderKeys fields;      // names in small letters without blanks: some may be written in two ways
  std::size_t bytes = 0;  // of the header, with the empty line that ends it
  bool ended = false;     // by an empty line
  std::string_view operator[](std::string_view name) const {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string_view{} : std::string_view(found->second);
  }
};

Nrrd parse(std::string_view text, const fs::path& path) {
  Nrrd nrrd;
  HeaderLines lines(text, path);
  lines.next();  // the magic
  while (const auto line = lines.next()) {
    nrrd.bytes = lines.position();
    nrrd.ended = line->empty();
    if (nrrd.ended) break;
    const std::size_t colon = line->find(':');
    // Comments, and keys with values of their own: nothing depends on them.
    if (line->starts_with('#') || colon == std::string_view::npos || line->substr(colon).starts_with(":="))
      continue;
    std::string name = lowerCase(line->substr(0, colon));
    std::erase(name, ' ');
    require(nrrd.fields.emplace(name, trimmed(line->substr(colon + 1))).second,
            "{} has the field \"{}\" twice; get a fresh copy.", path.string(), name.substr(0, 20));
  }
  return nrrd;
}

std::size_t typeBytes(std::string_view name) {
  if (name.starts_with("unsigned ")) name.remove_prefix(9);
  if (name.starts_with("signed ")) name.remove_prefix(7);
  static const std::map<std::string_view, std::size_t> bytes{
      {"char", 1},     {"uchar", 1},     {"int8", 1},      {"int8_t", 1},    {"uint8", 1},   {"uint8_t", 1},
      {"short", 2},    {"short int", 2}, {"ushort", 2},    {"int16", 2},     {"int16_t", 2}, {"uint16", 2},
      {"uint16_t", 2}, {"int", 4},       {"uint", 4},      {"int32", 4},     {"int32_t", 4}, {"uint32", 4},
      {"uint32_t", 4}, {"longlong", 8},  {"long long", 8}, {"ulonglong", 8}, {"int64", 8},   {"int64_t", 8},
      {"uint64", 8},   {"uint64_t", 8},  {"float", 4},     {"double", 8}};
  const auto found = bytes.find(name);
  return found == bytes.end() ? 0 : found->second;
}

// The sizes of three or four axes.
std::vector<std::int64_t> sizesOf(const Nrrd& nrrd, const fs::path& path) {
  const auto dimension = parseNumber<int>(nrrd["dimension"]);
  require(dimension && *dimension >= 1 && *dimension <= 16,
          "{} does not say how many dimensions it has; get a fresh copy.", path.string());
  require(*dimension == 3 || *dimension == 4, "{} has {} dimensions; a volume has 3, or 4 with time.",
          path.string(), *dimension);
  const auto sizes = parseNumbers<std::int64_t>(nrrd["sizes"]);
  require(sizes && sizes->size() == std::size_t(*dimension),
          "The sizes in {} are not {} numbers; get a fresh copy.", path.string(), *dimension);
  return *sizes;
}

// ITK has room for as many directions as the file has axes, and takes them of any length.
void checkSpace(const Nrrd& nrrd, const fs::path& path) {
  const std::string_view dimension = nrrd["spacedimension"];
  require((dimension.empty() || dimension == "3") && !lowerCase(nrrd["space"]).ends_with("time"),
          "The space of {} does not have three dimensions; save it with time as an axis of its own.",
          path.string());
  std::string numbers(nrrd["spacedirections"]);
  for (char& c : numbers)
    if (c == '(' || c == ')' || c == ',') c = ' ';
  for (const std::string_view word : words(numbers))
    require(word == "none" || isFinite(word),
            "The direction of the axes in {} is not finite; correct the header.", path.string());
  for (const std::string_view word : words(nrrd["spacings"]))
    require(lowerCase(word) == "nan" || isFinite(word),
            "The spacing in {} is not known here; it must be positive, correct the header.", path.string());
}

// Which axis is neither of space nor of volumes one after another is for ITK to say; here, what it means.
int timeAxis(const Nrrd& nrrd) {
  const auto kinds = words(nrrd["kinds"]);
  const auto found = std::find(kinds.begin(), kinds.end(), "list");
  return found == kinds.end() ? -1 : int(found - kinds.begin());
}

// In a file of four dimensions without kinds, ITK takes the last for time.
void checkKinds(const Nrrd& nrrd, const DeclaredData& data, const fs::path& path) {
  const auto kinds = words(nrrd["kinds"]);
  const bool timeFirst = !kinds.empty() && kinds[0] == "time";
  const bool unsaid = kinds.empty() && (nrrd["spacedirections"].starts_with("none") || data.sizes[0] <= 4);
  require(
      data.sizes.size() == 3 || !(timeFirst || unsaid),
      "{} does not say which of its four axes is time or colour; save it with \"kinds\", or with time last.",
      path.string());
}

// Whether three axes have a length; a fourth, of time or colour, need not.
bool spacingKnown(const Nrrd& nrrd, std::size_t axes) {
  const std::string directions = lowerCase(nrrd["spacedirections"]), spacings = lowerCase(nrrd["spacings"]);
  const auto lengths = words(directions.empty() ? spacings : directions);
  const auto unsaid = std::count_if(lengths.begin(), lengths.end(),
                                    [](std::string_view word) { return word == "none" || word == "nan"; });
  return !lengths.empty() && std::size_t(unsaid) <= axes - 3;
}

void placeData(const Nrrd& nrrd, const fs::path& path, DeclaredData& data) {
  const std::string_view file = nrrd["datafile"];
  require(!lowerCase(file).starts_with("list") && file.find('%') == std::string_view::npos,
          "{} spreads its data over several files; save it as one .nrrd file.", path.string());
  require(!file.empty() || nrrd.ended, "{} ends within its header; get a fresh copy.", path.string());
  data.file = file.empty() ? path : besideHeader(path, file);
  data.offset = file.empty() ? nrrd.bytes : 0;

  const std::string encoding = lowerCase(nrrd["encoding"]);
  if (encoding == "gzip" || encoding == "gz")
    data.encoding = Encoding::packed;
  else if (encoding == "txt" || encoding == "text" || encoding == "ascii")
    data.encoding = Encoding::text;
  else
    require(encoding == "raw",
            "{} is packed in the way \"{}\", which is not known here; save it with gzip or raw.",
            path.string(), encoding.substr(0, 20));
  const std::string_view lines = nrrd["lineskip"], skip = nrrd["byteskip"];
  require(lines.empty() || lines == "0", "{} skips lines before its data; save it again without.",
          path.string());
  const auto bytes = parseNumber<std::int64_t>(skip.empty() ? "0" : skip);
  require(bytes && *bytes >= 0, "{} has a byte skip that is not known here; save it again without.",
          path.string());
  (data.encoding == Encoding::packed ? data.skipped : data.offset) += std::uintmax_t(*bytes);
}

}  // namespace

DeclaredData nrrdData(const fs::path& path) {
  const std::string text = readHeaderText(path);
  const Nrrd nrrd = parse(text, path);
  DeclaredData data;
  data.sizes = sizesOf(nrrd, path);
  data.bytesPerNumber = typeBytes(lowerCase(nrrd["type"]));
  require(
      data.bytesPerNumber > 0,
      "{} has numbers of the type \"{}\", which is not known here; save it with whole numbers or as float.",
      path.string(), nrrd["type"].substr(0, 20));
  checkSpace(nrrd, path);
  checkKinds(nrrd, data, path);
  placeData(nrrd, path, data);
  data.timeAxis = timeAxis(nrrd);
  data.spacingKnown = spacingKnown(nrrd, data.sizes.size());
  return data;
}

}  // namespace sonoskin
