#!/usr/bin/env python3
"""make_dicom.py FOLDER: writes the small files of tests/data/dicom with pydicom, Pillow and DCMTK's tools, none of which the
program uses: what it reads in them is compared with what these were told. All of it is invented. Needs python3-pydicom,
python3-pil, python3-numpy and dcmtk; with the same versions the files come out the same."""
import io
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np
import pydicom
from PIL import Image
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.encaps import encapsulate
from pydicom.fileset import FileSet
from pydicom.sequence import Sequence
from pydicom.uid import (DeflatedExplicitVRLittleEndian, ExplicitVRBigEndian, ExplicitVRLittleEndian,
                         ImplicitVRLittleEndian, JPEG2000Lossless, JPEGBaseline8Bit, UID)

ROOT = "1.2.826.0.1.3680043.10.1111"
US, US_FRAMES = "1.2.840.10008.5.1.4.1.1.6.1", "1.2.840.10008.5.1.4.1.1.3.1"
ENHANCED_US, ENHANCED_CT = "1.2.840.10008.5.1.4.1.1.6.2", "1.2.840.10008.5.1.4.1.1.2.1"
CT, SECONDARY = "1.2.840.10008.5.1.4.1.1.2", "1.2.840.10008.5.1.4.1.1.7"
QLAB, STL = "1.2.840.113543.6.6.1.3.10002", "1.2.840.10008.5.1.4.1.1.104.3"
counter = 0


def voxel(i, j, k, t=0):
    """What the tests expect at a voxel: tests/core/dicom_files_test.cpp has the same."""
    return (7 * i + 13 * j + 29 * k + 50 * t) % 251


def volume(columns, rows, slices, t=0):
    k, j, i = np.mgrid[:slices, :rows, :columns]
    return voxel(i, j, k, t).astype(np.uint8)


def data_set(sop, pixels, syntax=ExplicitVRLittleEndian, modality="US"):
    """A file with these frames, rows and columns (and three colours)."""
    global counter
    counter += 1
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID = sop, f"{ROOT}.1.{counter}"
    meta.TransferSyntaxUID, meta.ImplementationClassUID = syntax, f"{ROOT}.9"
    ds = FileDataset(None, {}, file_meta=meta, preamble=bytes(128))
    ds.is_little_endian, ds.is_implicit_VR = syntax != ExplicitVRBigEndian, syntax == ImplicitVRLittleEndian
    ds.SOPClassUID, ds.SOPInstanceUID = sop, meta.MediaStorageSOPInstanceUID
    ds.Modality, ds.StudyInstanceUID, ds.SeriesInstanceUID = modality, f"{ROOT}.2", f"{ROOT}.3.{counter}"
    ds.PatientName, ds.PatientID, ds.StudyID, ds.InstanceNumber = "PLANTED^NAME", "PLANTED-ID", "1", 1
    ds.StudyDate, ds.StudyTime, ds.AccessionNumber, ds.SeriesNumber = "19990909", "010203", "PLANTED-NO", 1
    if pixels is not None:
        frames = pixels
        ds.SamplesPerPixel = 3 if frames.ndim == 4 else 1
        ds.PhotometricInterpretation = "RGB" if frames.ndim == 4 else "MONOCHROME2"
        if frames.ndim == 4:
            ds.PlanarConfiguration = 0
        ds.NumberOfFrames, ds.Rows, ds.Columns = frames.shape[:3]
        bits = 8 * frames.dtype.itemsize
        ds.BitsAllocated, ds.BitsStored, ds.HighBit, ds.PixelRepresentation = bits, bits, bits - 1, 0
        data = frames.astype(frames.dtype.newbyteorder(">" if syntax == ExplicitVRBigEndian else "<")).tobytes()
        ds.PixelData = data + bytes(len(data) % 2)
        ds["PixelData"].VR = "OB" if bits == 8 else "OW"
    return ds


def item(**values):
    ds = Dataset()
    for name, value in values.items():
        setattr(ds, name, value)
    return ds


def sequence(**values):
    return Sequence([item(**values)])


# ---- Enhanced US Volume: frames in a stored order that is not that of space

TURNED = [0, 1, 0, 0, 0, 1]  # rows along y, columns along z: the normal is x


def us_frame(k, t, kind="TISSUE_INTENSITY"):
    frame = Dataset()
    frame.FrameContentSequence = sequence(DimensionIndexValues=[t + 1, k + 1])
    position = Dataset()
    position.add_new(0x00209301, "FD", [10 + 0.8 * k, -5.0, 2.0])
    frame.add_new(0x0020930E, "SQ", Sequence([position]))
    time = Dataset()
    time.add_new(0x0020930D, "FD", 40.0 * t)
    frame.add_new(0x00209310, "SQ", Sequence([time]))
    data = Dataset()
    data.add_new(0x00189808, "CS", kind)
    frame.add_new(0x00189807, "SQ", Sequence([data]))
    return frame


def enhanced_us(order, kinds=("TISSUE_INTENSITY",)):
    """order: (slice, step, kind) of each frame."""
    frames = np.stack([volume(6, 4, 5, 2 * t + kind)[k] for k, t, kind in order])
    ds = data_set(ENHANCED_US, frames)
    ds.add_new(0x00209307, "CS", "APEX")
    ds.add_new(0x00209308, "FD", [11.6, -40.0, 2.6])
    ds.add_new(0x00209309, "FD", [0, 0, 1.0, -2.6, 0, 1, 0, 30, -1, 0, 0, 11.6, 0, 0, 0, 1])
    ds.DimensionOrganizationType = "3D_TEMPORAL"
    shared = Dataset()
    orientation = Dataset()
    orientation.add_new(0x00209302, "FD", [float(n) for n in TURNED])
    shared.add_new(0x0020930F, "SQ", Sequence([orientation]))
    shared.PixelMeasuresSequence = sequence(PixelSpacing=[0.3, 0.2], SliceThickness=2)
    ds.SharedFunctionalGroupsSequence = Sequence([shared])
    ds.PerFrameFunctionalGroupsSequence = Sequence([us_frame(k, t, kinds[kind]) for k, t, kind in order])
    return ds


def enhanced_us_index():
    """Time is told by the index of a dimension alone, in a syntax without types."""
    order = [(k, t) for t in range(2) for k in (3, 0, 4, 2, 1)][::-1]
    ds = data_set(ENHANCED_US, np.stack([volume(6, 4, 5, t)[k] for k, t in order]), ImplicitVRLittleEndian)
    dimensions = [Dataset(), Dataset()]
    for dimension, pointer in zip(dimensions, (0x0020930D, 0x00209301)):
        dimension.add_new(0x00209165, "AT", pointer)
    ds.DimensionIndexSequence = Sequence(dimensions)
    orientation = Dataset()
    orientation.add_new(0x00209302, "FD", [1.0, 0, 0, 0, 1, 0])
    shared = item(PixelMeasuresSequence=sequence(PixelSpacing=[0.3, 0.2]))
    shared.add_new(0x0020930F, "SQ", Sequence([orientation]))
    ds.SharedFunctionalGroupsSequence = Sequence([shared])
    frames = []
    for k, t in order:
        position = Dataset()
        position.add_new(0x00209301, "FD", [1.0, 2.0, 0.9 * k - 3])
        frame = item(FrameContentSequence=sequence(DimensionIndexValues=[t + 1, k + 1]))
        frame.add_new(0x0020930E, "SQ", Sequence([position]))
        frames.append(frame)
    ds.PerFrameFunctionalGroupsSequence = Sequence(frames)
    return ds


def enhanced_ct():
    """Each frame with a scale of its own, in a syntax without types."""
    frames = volume(5, 4, 3).astype(np.uint16) * 4
    ds = data_set(ENHANCED_CT, frames, ImplicitVRLittleEndian, "CT")
    shared = item(PlaneOrientationSequence=sequence(ImageOrientationPatient=[1, 0, 0, 0, 1, 0]),
                  PixelMeasuresSequence=sequence(PixelSpacing=[0.5, 0.25]))
    ds.SharedFunctionalGroupsSequence = Sequence([shared])
    ds.PerFrameFunctionalGroupsSequence = Sequence([
        item(PlanePositionSequence=sequence(ImagePositionPatient=[1, 2, 30 - 1.5 * k]),
             PixelValueTransformationSequence=sequence(RescaleIntercept=-1000, RescaleSlope=k + 1))
        for k in range(3)])
    return ds


# ---- ultrasound of several frames

def region(x0, y0, x1, y1, dx, dy, units=3, kind=1):
    return item(RegionSpatialFormat=1, RegionDataType=kind, RegionFlags=0, RegionLocationMinX0=x0,
                RegionLocationMinY0=y0, RegionLocationMaxX1=x1, RegionLocationMaxY1=y1,
                PhysicalUnitsXDirection=units, PhysicalUnitsYDirection=units, PhysicalDeltaX=dx, PhysicalDeltaY=dy)


def us_sweep(**values):
    ds = data_set(US_FRAMES, volume(8, 6, 4) | 1)
    ds.FrameIncrementPointer, ds.FrameTime = 0x00181063, 33.3
    for name, value in values.items():
        setattr(ds, name, value)
    return ds


# ---- makers' own

def qlab(steps=2):
    ds = data_set(QLAB, np.concatenate([volume(6, 4, 5, t) for t in range(steps)]))
    ds.NumberOfFrames, ds.FrameTime = steps, 50
    ds.PhysicalUnitsXDirection = ds.PhysicalUnitsYDirection = 3
    ds.PhysicalDeltaX, ds.PhysicalDeltaY = 0.05, 0.06
    ds.add_new(0x30010010, "LO", "Philips3D")
    ds.add_new(0x30011001, "UL", 5)
    ds.add_new(0x30011002, "US", 3)
    ds.add_new(0x30011003, "FD", 0.07)
    return ds


def affinity(block=0x33):
    ds = data_set(US_FRAMES, volume(6, 4, 5))
    ds.FrameTime = 20
    ds.add_new(0x200D0010, "LO", "Philips US Imaging DD 001")
    ds.add_new(0x200D1003, "LO", "9\\9\\9")
    ds.add_new(0x200D0000 | block, "LO", "Philips US Imaging DD 036")
    ds.add_new(0x200D0003 | block << 8, "LO", "0.41\\0.52\\0.63")
    return ds


def iu22():
    ds = data_set(US, volume(9, 8, 1))
    ds.add_new(0x200D0030, "LO", "Philips US Imaging DD 033")
    ds.add_new(0x200D0031, "LO", "Philips US Imaging DD 036")
    ds.add_new(0x200D300B, "OB", volume(6, 4, 5).tobytes())
    ds.add_new(0x200D3101, "LO", "6\\4\\5")
    ds.add_new(0x200D3103, "LO", "0.41\\0.52\\0.63")
    return ds


def eigen():
    ds = data_set(US_FRAMES, volume(6, 4, 5))
    ds.Manufacturer, ds.ManufacturerModelName, ds.FrameTime = "Eigen", "Artemis", 20
    ds.PixelAspectRatio = [350, 350]
    return ds


def movie_group():
    ds = data_set(US_FRAMES, volume(6, 4, 5))
    ds.FrameTime = 20
    ds.add_new(0x7FE10010, "LO", "GEMS_Ultrasound_MovieGroup_001")
    inner = Dataset()
    inner.add_new(0x7FE10010, "LO", "GEMS_Ultrasound_MovieGroup_001")
    inner.add_new(0x7FE11002, "LO", "Trace+3D")
    ds.add_new(0x7FE11001, "SQ", Sequence([inner]))
    return ds


def philips_native():
    ds = data_set(US, volume(6, 4, 1))
    ds.add_new(0x200D003C, "LO", "Philips US Imaging DD 045")
    inner = Dataset()
    inner.add_new(0x200D003C, "LO", "Philips US Imaging DD 045")
    inner.add_new(0x200D3CFA, "LO", "ZLib")
    ds.add_new(0x200D3CF8, "SQ", Sequence([inner]))
    return ds


def encapsulated_stl():
    ds = data_set(STL, None, modality="M3D")
    ds.EncapsulatedDocument, ds.MIMETypeOfEncapsulatedDocument = b"solid a\nendsolid a\n ", "model/stl"
    return ds


# ---- pixels in all their coats; three places 2 mm apart

def placed(ds):
    ds.SpacingBetweenSlices, ds.PixelSpacing = 2, [0.5, 0.5]
    ds.ImagePositionPatient, ds.ImageOrientationPatient = [0, 0, 0], [1, 0, 0, 0, 1, 0]
    return ds


def smooth(columns=16, rows=16, slices=3):
    k, j, i = np.mgrid[:slices, :rows, :columns]
    return (40 + 8 * i + 3 * j + 10 * k).astype(np.uint8)


def jpeg(picture, **options):
    out = io.BytesIO()
    Image.fromarray(picture).save(out, "JPEG", quality=95, **options)
    return out.getvalue()


def packed(pixels, syntax, pictures, photometric, **pieces):
    ds = placed(data_set(SECONDARY, pixels, syntax, "OT"))
    ds.PhotometricInterpretation = photometric
    ds.PixelData = encapsulate(pictures, **pieces)
    ds["PixelData"].is_undefined_length = True
    return ds


def jpeg2000(picture, boxed=False):
    out = io.BytesIO()
    Image.fromarray(picture).save(out, "JPEG2000", irreversible=False, no_jp2=not boxed)
    return out.getvalue()


def coats():
    grey = smooth()
    colour = np.repeat(grey[..., None], 3, axis=3)
    wide = grey.astype(np.uint16) * 200
    rgb = [jpeg(p, subsampling=0) for p in colour]
    assert all(p[6:10] == b"JFIF" for p in rgb)
    yield "jpeg_grey", packed(grey, JPEGBaseline8Bit, [jpeg(p) for p in grey], "MONOCHROME2")
    yield "jpeg_called_rgb", packed(colour, JPEGBaseline8Bit, rgb, "RGB")
    yield "jpeg_ybr422", packed(colour, JPEGBaseline8Bit, [jpeg(p, subsampling=1) for p in colour], "YBR_FULL_422")
    # Without a mark, in a lower resolution of colour: only YCbCr has that.
    bare = [p[:2] + p[20:] for p in (jpeg(p, subsampling=2) for p in colour)]
    yield "jpeg_bare_420", packed(colour, JPEGBaseline8Bit, bare, "RGB")
    yield "jpeg2000", packed(wide, JPEG2000Lossless, [jpeg2000(p) for p in wide], "MONOCHROME2")
    yield "jpeg2000_rct", packed(colour, JPEG2000Lossless, [jpeg2000(p) for p in colour], "YBR_RCT")
    for name, table in (("pieces", True), ("pieces_without_table", False)):
        pictures = [jpeg2000(p) for p in wide]
        yield f"jpeg2000_{name}", packed(wide, JPEG2000Lossless, pictures, "MONOCHROME2", fragments_per_frame=3, has_bot=table)
    yield "plain", placed(data_set(SECONDARY, grey, modality="OT"))
    yield "wide", placed(data_set(SECONDARY, wide, modality="OT"))
    yield "big_endian", placed(data_set(SECONDARY, wide, ExplicitVRBigEndian, "OT"))
    yield "deflated", placed(data_set(SECONDARY, grey, DeflatedExplicitVRLittleEndian, "OT"))
    planes = placed(data_set(SECONDARY, colour, modality="OT"))
    planes.PlanarConfiguration, planes.PixelData = 1, np.moveaxis(colour, 3, 1).tobytes()
    yield "planes", planes
    ybr = placed(data_set(SECONDARY, np.stack([grey, 0 * grey + 128, 0 * grey + 128], axis=3), modality="OT"))
    ybr.PhotometricInterpretation = "YBR_FULL"
    yield "ybr_full", ybr
    pairs = placed(data_set(SECONDARY, colour, modality="OT"))
    pairs.PhotometricInterpretation = "YBR_FULL_422"
    both = np.stack([grey[..., ::2], grey[..., 1::2], 0 * grey[..., ::2] + 128, 0 * grey[..., ::2] + 128], axis=3)
    pairs.PixelData = both.tobytes()
    yield "ybr_pairs", pairs
    palette = placed(data_set(SECONDARY, 255 - grey, modality="OT"))
    palette.PhotometricInterpretation = "PALETTE COLOR"
    table = ((255 - np.arange(256)).astype("<u2") * 257).tobytes()
    for name in ("Red", "Green", "Blue"):
        setattr(palette, f"{name}PaletteColorLookupTableDescriptor", [256, 0, 16])
        setattr(palette, f"{name}PaletteColorLookupTableData", table)
    yield "palette", palette


def recoded(folder):
    """The same with DCMTK's encoders."""
    run = lambda *words: subprocess.run([str(w) for w in words], check=True)
    run("dcmcjpeg", "+un", "+e1", folder / "wide.dcm", folder / "jpeg_lossless.dcm")
    # Of 12 bits. The encoder stretches the greys over all of them, so that its own decoder has to tell what is right.
    run("dcmcjpeg", "+un", "+ee", "+bt", "+q", 98, folder / "wide.dcm", folder / "jpeg_extended.dcm")
    run("dcmdjpeg", folder / "jpeg_extended.dcm", folder / "jpeg_extended_plain.dcm")
    run("dcmcjpls", "+el", folder / "wide.dcm", folder / "jpeg_ls.dcm")
    run("dcmcrle", folder / "wide.dcm", folder / "rle.dcm")
    run("dcmcrle", folder / "planes.dcm", folder / "rle_colour.dcm")


def blank():
    """Slices of one value take hardly any bytes."""
    pixels = np.zeros((3, 512, 512), np.uint16)
    pixels[1, 100, 200] = 1000
    return packed(pixels, JPEG2000Lossless, [jpeg2000(p) for p in pixels], "MONOCHROME2")


def contradicted(folder):
    """Streams that are of other pixels than the file says."""
    grey = smooth()
    wide, large = grey.astype(np.uint16) * 200, [np.concatenate([p, p]) for p in grey]
    streams = {"jpeg_other_size": (JPEGBaseline8Bit, [jpeg(p) for p in large]),
               "jpeg2000_boxed_other_size": (JPEG2000Lossless, [jpeg2000(p, boxed=True) for p in large]),
               "jpeg2000_called_8": (JPEG2000Lossless, [jpeg2000(p) for p in wide])}
    save(folder, {name: packed(grey, syntax, s, "MONOCHROME2") for name, (syntax, s) in streams.items()})
    for name in ("jpeg_lossless", "jpeg_ls"):
        ds = pydicom.dcmread(folder / f"{name}.dcm")
        ds.BitsAllocated, ds.BitsStored, ds.HighBit = 8, 8, 7
        save(folder, {f"{name}_called_8": ds})


# ---- a DICOMDIR with two series

def file_set(folder):
    files = FileSet()
    files.UID = UID(f"{ROOT}.5")
    with tempfile.TemporaryDirectory() as name:
        for series, slices in ((1, 4), (2, 3)):
            for k in range(slices):
                ds = data_set(CT, volume(5, 4, 8)[k:k + 1], modality="CT")
                del ds.NumberOfFrames
                ds.SeriesInstanceUID, ds.SeriesNumber = f"{ROOT}.4.{series}", series
                ds.InstanceNumber, ds.PixelSpacing = k + 1, [0.5, 0.5]
                ds.ImagePositionPatient, ds.ImageOrientationPatient = [0, 0, 2.0 * k], [1, 0, 0, 0, 1, 0]
                path = pathlib.Path(name) / f"{series}_{k}.dcm"
                ds.save_as(path)
                files.add(str(path))
        shutil.rmtree(folder, ignore_errors=True)
        files.write(str(folder))


def save(folder, named):
    for name, ds in named.items():
        ds.save_as(folder / f"{name}.dcm", write_like_original=False)


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    shuffled = [(k, t, 0) for k, t in ((3, 1), (0, 0), (4, 1), (2, 0), (1, 1), (4, 0), (0, 1), (1, 0), (2, 1), (3, 0))]
    both = [(k, 0, kind) for k in range(5) for kind in range(2)]
    regions = Sequence([region(0, 0, 7, 0, 1, 1, units=0), region(1, 1, 6, 5, 0.02, 0.03)])
    named = {
        "enhanced_us": enhanced_us(shuffled),
        "enhanced_us_flow": enhanced_us(both, ("TISSUE_INTENSITY", "FLOW_VELOCITY")),
        "enhanced_ct": enhanced_ct(),
        "us_spacing": us_sweep(SpacingBetweenSlices=0.75, PixelSpacing=[0.3, 0.2]),
        "us_regions": us_sweep(SpacingBetweenSlices=0.75, SequenceOfUltrasoundRegions=regions, BurnedInAnnotation="YES"),
        "us_film": us_sweep(PixelSpacing=[0.3, 0.2]),
        "qlab": qlab(), "affinity": affinity(), "iu22": iu22(), "eigen": eigen(), "movie_group": movie_group(),
        "philips_native": philips_native(), "encapsulated_stl": encapsulated_stl(), **dict(coats())}
    save(folder, named)
    recoded(folder)
    file_set(folder / "file_set")
    save(folder, {"enhanced_us_index": enhanced_us_index()})
    contradicted(folder)
    boxed = [jpeg2000(p, boxed=True) for p in smooth()]
    save(folder, {"jpeg2000_boxed": packed(smooth(), JPEG2000Lossless, boxed, "MONOCHROME2"),
                  "jpeg2000_blank": blank()})


if __name__ == "__main__":
    main()
