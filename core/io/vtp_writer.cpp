#include <fmt/format.h>
#include <libdeflate.h>

#include <memory>
#include <new>
#include <string>

#include "core/base/version.h"
#include "core/io/byte_sink.h"
#include "core/io/mesh_encoders.h"
#include "core/io/meshes/base64.h"

namespace sonoskin {
namespace {

// Arrays: their descriptions and, behind the header, their bytes: zlib's blocks in letters, so that the whole stays XML.
class Arrays {
 public:
  Arrays() : packer_(libdeflate_alloc_compressor(6), libdeflate_free_compressor) {
    if (!packer_) throw std::bad_alloc();
  }

  // add: one of `count` bytes.
  std::string add(const std::string& what, const void* data, std::size_t count) {
    const std::string described =
        fmt::format("<DataArray {} format=\"appended\" offset=\"{}\"/>\n", what, letters_.size());
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    const std::uint64_t blocks = (count + kBlock - 1) / kBlock;
    ByteSink head, packed;
    head.number(blocks);
    head.number(std::uint64_t(kBlock));
    head.number(std::uint64_t(count % kBlock));
    Bytes block(libdeflate_zlib_compress_bound(packer_.get(), kBlock));
    for (std::size_t at = 0; at < count; at += kBlock) {
      const std::size_t size = libdeflate_zlib_compress(
          packer_.get(), bytes + at, std::min(kBlock, count - at), block.data(), block.size());
      head.number(std::uint64_t(size));
      packed.array(Bytes(block.begin(), block.begin() + std::ptrdiff_t(size)));
    }
    letters_ += toBase64(head.take());
    letters_ += toBase64(packed.take());
    return described;
  }
  const std::string& letters() const { return letters_; }

 private:
  static constexpr std::size_t kBlock = 1u << 20;
  std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> packer_;
  std::string letters_;
};

template <class T>
std::string described(Arrays& arrays, const std::string& what, const std::vector<T>& values) {
  return arrays.add(what, values.data(), values.size() * sizeof(T));
}

std::string pointData(const Mesh& mesh, Arrays& arrays) {
  std::string text = mesh.normals.empty() ? "<PointData>\n" : "<PointData Normals=\"Normals\">\n";
  if (!mesh.normals.empty())
    text += described(arrays, "type=\"Float32\" Name=\"Normals\" NumberOfComponents=\"3\"", mesh.normals);
  if (!mesh.visibility.empty())
    text += described(arrays, "type=\"Float32\" Name=\"visibility\"", mesh.visibility);
  if (!mesh.measured.empty()) text += described(arrays, "type=\"Float32\" Name=\"measured\"", mesh.measured);
  if (!mesh.labels.empty()) text += described(arrays, "type=\"UInt8\" Name=\"label\"", mesh.labels);
  return text + "</PointData>\n";
}

std::string polygons(const Mesh& mesh, Arrays& arrays) {
  std::vector<std::int64_t> corners, ends;
  for (const Triangle& t : mesh.triangles) {
    corners.insert(corners.end(), t.begin(), t.end());
    ends.push_back(std::int64_t(corners.size()));
  }
  return "<Polys>\n" + described(arrays, "type=\"Int64\" Name=\"connectivity\"", corners) +
         described(arrays, "type=\"Int64\" Name=\"offsets\"", ends) + "</Polys>\n";
}

}  // namespace

Bytes encodeVtp(const Mesh& mesh, const MeshPlacement& placement) {
  Arrays arrays;
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<!-- Sonoskin {}, {} -->\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
      "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n"
      "<FieldData>\n<Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">{} "
      "0</Array>\n"
      "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      kVersion, placementText(placement), placement.frame == MeshFrame::ras ? "82 65 83" : "76 80 83",
      mesh.positions.size(), mesh.triangles.size());
  text += pointData(mesh, arrays) + "<CellData>\n</CellData>\n<Points>\n" +
          described(arrays, "type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"", mesh.positions) +
          "</Points>\n" + polygons(mesh, arrays) +
          "</Piece>\n</PolyData>\n<AppendedData encoding=\"base64\">\n_" + arrays.letters() +
          "\n</AppendedData>\n</VTKFile>\n";
  return {text.begin(), text.end()};
}

}  // namespace sonoskin
