#include "app/document/opening.h"

#include "app/document/input.h"
#include "core/io/volume_reader.h"
#include "core/phantom/phantom.h"
#include "core/volume/mirror_scan.h"

namespace sonoskin {

void readVolumeTo(Opened& opened, const ScanOptions& options, const Progress& progress) {
  Scan& scan = opened.scan;
  scan = readScan(opened.source, readOptions(options, opened.raw), progress);
  opened.givesSpacing = scan.spacingKnown;
  if (!opened.givesSpacing) setSpacing(scan, options.spacing);
  warnOfSpacing(scan);
  noteTimeSteps(scan);
  fitIntoMemory(scan, options);
  mirrorScan(scan, options.mirror);
  opened.reading = options;
}

void simulateTo(Opened& opened, const ScanOptions& options, const Progress& progress) {
  opened.scan = makePhantomScan(*opened.phantom, progress);
  fitIntoMemory(opened.scan, options);
  mirrorScan(opened.scan, options.mirror);
  opened.reading = options;
}

}  // namespace sonoskin
