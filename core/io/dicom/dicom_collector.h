#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/io/dicom/dicom_stacks.h"

namespace sonoskin {

// DicomFile: one file, as far as its header tells.
//   region       of its own frames
//   kretz        where a whole GE Kretz file lies in it, offset and length; 0 bytes: none does
//   inflatedAt   from where on it is to be unpacked as a whole; 0: it is not
//   hasBurnedIn  text in its pictures, by its own word
struct DicomFile {
  std::filesystem::path path;
  std::uint64_t bytes = 0;
  DicomPixels pixels;
  std::optional<DicomRegion> region;
  std::pair<std::uint64_t, std::uint64_t> kretz{};
  std::uint64_t inflatedAt = 0;
  bool hasBurnedIn = false;

  // open: to read its pixels; `named` as DicomSource has it.
  DicomSource open(const std::filesystem::path& named) const;
};

// DicomFiles: the files at hand and the volumes that they make.
//   warnings  to be said of all
struct DicomFiles {
  std::vector<DicomFile> files;
  std::vector<DicomVolume> volumes;
  std::vector<std::string> warnings;
};

// DicomCollector: takes up files one by one and puts them together. A file of several frames makes volumes alone; those of
// one frame make series.
class DicomCollector {
 public:
  // path: the file or folder that a person gave, for sentences
  explicit DicomCollector(const std::filesystem::path& path) : path_(path) {}

  // add: a file; of a series that is named, only where it belongs to that one.
  //   errors  Error: it is damaged, or holds no pictures; then it is as if it had not been added
  void add(const std::filesystem::path& file, const std::string& onlySeries = {});
  // lastSlice: the series of the file that was added last, where it is one slice that may have neighbours.
  std::optional<std::string> lastSlice() const;
  // finish: what the files make, in the order in which they came.
  DicomFiles finish();

 private:
  void addPictures(const DicomDataSet& set, DicomSource& source);
  void addKretz(const DicomElement& element, DicomSource& source);
  void addFrames(const DicomItem& root, std::vector<DicomFrame> frames, const DicomSpacing& spacing);
  void push(std::vector<DicomVolume> volumes);

  std::filesystem::path path_;
  DicomFiles found_;
  std::vector<DicomFrame> slices_;
  std::vector<std::string> modalities_;  // of the files
  std::vector<std::vector<std::string>> warnings_;
  std::set<std::string> identities_;
  std::string lastSeries_;
  int copies_ = 0;
};

}  // namespace sonoskin
