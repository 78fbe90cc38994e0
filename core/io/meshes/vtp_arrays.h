#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

// A file of VTK's XML formats: its header, and its arrays of numbers, wherever and however they are kept.
// [VTK file formats, "XML file formats"]
namespace sonoskin {

// VtkXmlArray: a DataArray as it is described. section: the element that it lies in, such as "PointData".
struct VtkXmlArray {
  std::string section, name, type, format, text;
  std::size_t components = 1, offset = 0;
};

// VtkPiece: attributes are those of the piece, and as "PointData.Normals" those of its sections.
struct VtkPiece {
  std::map<std::string, std::string, std::less<>> attributes;
  std::vector<VtkXmlArray> arrays;
};

// VtkXmlFile: the whole.
//   fields    the arrays of the FieldData
class VtkXmlFile {
 public:
  // errors  Error: damaged, of another kind than `type` (such as "PolyData"), packed by another than zlib
  VtkXmlFile(const std::filesystem::path& path, std::string_view type);

  const std::vector<VtkPiece>& pieces() const { return pieces_; }
  const std::vector<VtkXmlArray>& fields() const { return fields_; }
  // numbers: of an array; a text's are its letters'.
  //   errors  Error: damaged; more of them than the bytes that are there can hold, which is looked at first
  std::vector<double> numbers(const VtkXmlArray& array) const;
  void check(bool holds) const;

 private:
  class HeaderWalk;
  void parse(std::string_view xml, std::string_view type);
  std::uint64_t word(std::string_view bytes, std::size_t index) const;
  std::string bytesOf(const VtkXmlArray& array) const;
  std::string plain(std::string_view stored, bool isBase64) const;
  std::string unpacked(std::string_view stored, bool isBase64) const;

  std::filesystem::path path_;
  std::vector<std::uint8_t> file_;
  std::string_view appended_;
  bool appendedIsBase64_ = false, isBigEndian_ = false, isPacked_ = false;
  std::size_t wordBytes_ = 4;
  std::vector<VtkPiece> pieces_;
  std::vector<VtkXmlArray> fields_;
};

}  // namespace sonoskin
