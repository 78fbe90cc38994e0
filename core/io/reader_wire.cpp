#include "core/io/reader_wire.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "core/base/error.h"
#include "core/io/loaded_mesh.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

class Writer {
 public:
  explicit Writer(const Write& write) : write_(write) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(const T& value) const { write_(&value, sizeof value); }
  template <class T>
  void operator()(const std::vector<T>& values) const {
    (*this)(std::uint64_t(values.size()));
    write_(values.data(), values.size() * sizeof(T));
  }
  void operator()(const std::string& text) const {
    (*this)(std::uint64_t(text.size()));
    write_(text.data(), text.size());
  }

 private:
  const Write& write_;
};

class ByteReader {
 public:
  ByteReader(std::span<const std::uint8_t> bytes, const fs::path& path) : bytes_(bytes), path_(path) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(T& value) { take(&value, sizeof value); }
  void operator()(bool& value) {
    std::uint8_t byte = 0;
    (*this)(byte);
    value = byte != 0;
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    values.resize(count(sizeof(T)));
    take(values.data(), values.size() * sizeof(T));
  }
  void operator()(std::string& text) {
    text.resize(count(1));
    take(text.data(), text.size());
  }

 private:
  std::size_t count(std::size_t bytesEach) {
    std::uint64_t count = 0;
    (*this)(count);
    check(count <= bytes_.size() / bytesEach);
    return std::size_t(count);
  }
  void take(void* to, std::size_t bytes) {
    check(bytes <= bytes_.size());
    if (bytes > 0) std::memcpy(to, bytes_.data(), bytes);
    bytes_ = bytes_.subspan(bytes);
  }
  void check(bool holds) const {
    require(holds, "{} gave numbers that contradict each other: it is damaged; get a fresh copy.",
            path_.string());
  }

  std::span<const std::uint8_t> bytes_;
  const fs::path& path_;
};

// The same order for both ways. V: LoadedVolume, const where it is written.
template <class F, class V>
void walkVolume(F& f, V& v) {
  auto& s = v.stored;
  auto& g = s.geometry;
  f(s.format), f(g.dims), f(g.spacing), f(g.origin), f(g.direction);
  f(s.spacingKnown), f(s.type), f(s.components), f(s.timeSteps), f(s.stepSeconds), f(s.modality);
  f(s.padding), f(v.bytes), f(v.numbers), f(v.mask);
}

template <class F, class M>
void walkMesh(F& f, M& m) {
  f(m.positions), f(m.normals), f(m.visibility), f(m.triangles), f(m.cornerUvs), f(m.measured), f(m.labels);
}

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// The same order for both ways. G: SampleGrid's kinds, const where they are written.
template <class F, class G>
requires std::is_same_v<std::remove_const_t<G>, SweptGrid>
void walkGrid(F& f, G& g) {
  f(g.samples), f(g.firstRadius), f(g.sampleDistance), f(g.axisDepth), f(g.fan), f(g.sweep), f(g.parallel);
}
template <class F, class G>
requires std::is_same_v<std::remove_const_t<G>, PyramidGrid>
void walkGrid(F& f, G& g) { f(g.dims), f(g.lateral), f(g.depth), f(g.aperture), f(g.growth); }

void writeGrid(const Writer& f, const std::optional<SampleGrid>& grid) {
  f(std::uint8_t(grid ? 1 + grid->index() : 0));
  if (grid) std::visit([&](const auto& g) { walkGrid(f, g); }, *grid);
}

void takeGrid(ByteReader& f, std::optional<SampleGrid>& grid) {
  std::uint8_t kind = 0;
  if (f(kind); kind == 0) return;
  if (kind == 1)
    walkGrid(f, std::get<SweptGrid>(grid.emplace(SweptGrid{})));
  else
    walkGrid(f, std::get<PyramidGrid>(grid.emplace(PyramidGrid{})));
}

void writeOptionals(const Writer& f, const StoredVolume& s) {
  writeGrid(f, s.grid);
  f(std::uint8_t(s.unitRange.has_value()));
  if (s.unitRange) f(s.unitRange->first), f(s.unitRange->second);
  f(std::uint8_t(s.beam.has_value()));
  if (!s.beam) return;
  f(std::uint8_t(s.beam->apex.has_value()));
  if (s.beam->apex) f(*s.beam->apex);
  f(s.beam->axis), f(s.beam->up);
}

void takeOptionals(ByteReader& f, StoredVolume& s) {
  takeGrid(f, s.grid);
  bool has = false;
  if (f(has); has) f(s.unitRange.emplace().first), f(s.unitRange->second);
  if (f(has); !has) return;
  s.beam.emplace();
  if (f(has); has) f(s.beam->apex.emplace());
  f(s.beam->axis), f(s.beam->up);
}

bool isSound(const LoadedVolume& v) {
  const StoredVolume& s = v.stored;
  constexpr int kMost = 1 << 16;
  const auto fits = [](int number) { return number >= 1 && number <= kMost; };
  if (std::size_t(s.type) > std::size_t(NumberType::float64) || !fits(s.components) || !fits(s.timeSteps) ||
      !(s.stepSeconds >= 0) || !std::isfinite(s.stepSeconds) || !fits(s.geometry.dims.x) ||
      !fits(s.geometry.dims.y) || !fits(s.geometry.dims.z))
    return false;
  if (s.padding.size() > 1 && s.padding.size() != std::size_t(s.geometry.dims.z)) return false;
  if (s.beam &&
      !(isFinite(s.beam->axis) && isFinite(s.beam->up) && isFinite(s.beam->apex.value_or(glm::dvec3(0)))))
    return false;
  if (!v.mask.empty() && (s.grid || v.mask.size() != s.geometry.voxels())) return false;
  if (s.grid && (gridFault(*s.grid) || gridDims(*s.grid) != s.geometry.dims)) return false;
  const double expected =
      double(s.geometry.voxels()) * double(s.components) * double(numberTypeBytes(s.type));
  return double(v.numbers.size()) == expected;
}

}  // namespace

void writeAnswer(const LoadedVolume& volume, const Write& write) {
  const Writer writer(write);
  writeOptionals(writer, volume.stored);
  walkVolume(writer, volume);
}

void writeAnswer(const Mesh& mesh, const Write& write) {
  const Writer writer(write);
  walkMesh(writer, mesh);
}

void writeAnswer(const std::vector<VolumeEntry>& entries, const Write& write) {
  const Writer writer(write);
  writer(std::uint64_t(entries.size()));
  for (const VolumeEntry& entry : entries)
    writer(entry.dims), writer(entry.timeSteps), writer(entry.modality);
}

LoadedVolume volumeFrom(std::span<const std::uint8_t> answer, const fs::path& path) {
  ByteReader reader(answer, path);
  LoadedVolume volume;
  takeOptionals(reader, volume.stored);
  walkVolume(reader, volume);
  require(isSound(volume), "{} gave numbers that contradict each other: it is damaged; get a fresh copy.",
          path.string());
  checkGeometry(volume.stored, path);
  return volume;
}

std::vector<VolumeEntry> entriesFrom(std::span<const std::uint8_t> answer, const fs::path& path) {
  constexpr std::uint64_t kMost = 100'000;
  ByteReader reader(answer, path);
  std::uint64_t count = 0;
  reader(count);
  std::vector<VolumeEntry> entries(std::size_t(std::min(count, kMost)));
  for (VolumeEntry& entry : entries) reader(entry.dims), reader(entry.timeSteps), reader(entry.modality);
  return entries;
}

Mesh meshFrom(std::span<const std::uint8_t> answer, const fs::path& path) {
  ByteReader reader(answer, path);
  Mesh mesh;
  walkMesh(reader, mesh);
  checkMesh(mesh, path);
  return mesh;
}

}  // namespace sonoskin
