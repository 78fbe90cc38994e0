#include "core/io/headers/declared_volume.h"

#include <set>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/headers/declared_data.h"
#include "core/io/headers/tracked_pictures.h"
#include "core/io/headers/voxel_numbers.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

DeclaredData headerOf(FileFormat format, const fs::path& path) {
  switch (format) {
    case FileFormat::nrrd:
      return nrrdData(path);
    case FileFormat::meta:
      return metaData(path);
    case FileFormat::nifti:
      return niftiData(path);
    default:
      return vtkData(path);
  }
}

}  // namespace

void takeKeys(const HeaderKeys& keys, DeclaredData& data, const fs::path& path) {
  data.stored.beam = beamFromKeys(keys);
  data.stored.unitRange = rangeFromKeys(keys);
  if (data.poses) *data.poses = posesFrom(keys, path);
}

LoadedVolume readDeclared(FileFormat format, const fs::path& path, int time, const Progress& progress) {
  progress.update(0);
  const DeclaredData data = headerOf(format, path);
  LoadedVolume loaded;
  if (data.poses) {
    checkTime(time, 1, path);
    loaded = reconstructPictures(data, path, progress);
  } else {
    loaded.stored = data.stored;
    checkGeometry(loaded.stored, path);
    checkTime(time, loaded.stored.timeSteps, path);
    loaded.numbers = readNumbers(data, path, time - 1, progress);
  }
  loaded.stored.format = formatName(format);
  std::set<fs::path> files{path};
  for (const DataPart& part : data.parts) files.insert(part.file);
  for (const fs::path& file : files) loaded.bytes += fileSize(file);
  progress.update(1);
  return loaded;
}

}  // namespace sonoskin
