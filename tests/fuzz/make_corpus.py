#!/usr/bin/env python3
"""make_corpus.py FOLDER: writes small files for every fuzzer into FOLDER/<target>; those named good_* must be accepted."""
import bz2
import gzip
import json
import pathlib
import struct
import sys
import zlib

from corpus_meshes import glb, mesh_answer, obj, ply, stl_binary, stl_text, three_mf, vtk_surface, vtp, zipped


def broken(good, step=7):
    """Cuts and flipped bytes of a good file, a few of each."""
    for at in range(step, len(good), max(step, len(good) // 6)):
        yield f"cut_{at}", good[:at]
        yield f"flip_{at}", good[:at] + bytes([good[at] ^ 0xFF]) + good[at + 1:]


# ---- volumes

VOXELS = bytes(range(24))  # 4 x 3 x 2


def nrrd(encoding, data, extra=""):
    head = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 4 3 2\n"
            f"space directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\nkinds: domain domain domain\nencoding: {encoding}\n"
            f"space origin: (0,0,0)\nsonoskin_beam_axis:=0 1 0\n{extra}\n")
    return head.encode() + data


def meta(extra, data):
    return (f"ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n{extra}"
            "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\nElementSpacing = 0.5 0.5 0.5\nDimSize = 4 3 2\n"
            "AnatomicalOrientation = RAI\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n").encode() + data


def vtk(form, data):
    return (f"# vtk DataFile Version 3.0\ntitle\n{form}\nDATASET STRUCTURED_POINTS\nDIMENSIONS 4 3 2\n"
            "SPACING 0.5 0.5 0.5\nORIGIN 0 0 0\nPOINT_DATA 24\nSCALARS scalars unsigned_char 1\n"
            "LOOKUP_TABLE default\n").encode() + data


def nifti(q=1, s=0):
    head = bytearray(348)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, 4, 3, 2, 1, 1, 1, 1)
    struct.pack_into("<2h", head, 70, 2, 8)
    struct.pack_into("<8f", head, 76, 1, 0.5, 0.5, 0.5, 0, 0, 0, 0)
    struct.pack_into("<3f", head, 108, 352, 1, 0)
    head[123] = 2
    struct.pack_into("<2h", head, 252, q, s)
    struct.pack_into("<12f", head, 280, -0.5, 0, 0, 3, 0, -0.5, 0, 4, 0, 0, 0.5, 5)
    head[344:348] = b"n+1\0"
    return bytes(head) + bytes(4) + VOXELS


def dicom(implicit=False, series=None, number=1, place=0):
    """A file of three frames or, of a series, of one slice."""
    def element(tag, vr, value):
        value += b"\0" * (len(value) % 2)
        if implicit and tag >> 16 != 2:
            return struct.pack("<HHI", tag >> 16, tag & 0xFFFF, len(value)) + value
        if vr in ("OB", "OW", "SQ"):
            return struct.pack("<HH2sHI", tag >> 16, tag & 0xFFFF, vr.encode(), 0, len(value)) + value
        return struct.pack("<HH2sH", tag >> 16, tag & 0xFFFF, vr.encode(), len(value)) + value

    def numbers(tag, *values):
        return b"".join(element(tag + n, "US", struct.pack("<H", value)) for n, value in enumerate(values))

    syntax = b"1.2.840.10008.1.2" + (b"" if implicit else b".1")
    item = element(0x00080060, "CS", b"US")
    sequence = struct.pack("<HHI", 0xFFFE, 0xE000, len(item)) + item
    frames = b"" if series else element(0x00280008, "IS", b"3")
    places = element(0x00200032, "DS", b"0\\0\\%d" % place) + element(0x00200037, "DS", b"1\\0\\0\\0\\1\\0")
    return (bytes(128) + b"DICM" + element(0x00020010, "UI", syntax) + element(0x00080018, "UI", b"1.%d" % number)
            + element(0x00080060, "CS", b"US") + element(0x00081140, "SQ", sequence)
            + element(0x00180088, "DS", b"0.8") + element(0x0020000E, "UI", series or b"1.2") + places + frames
            + numbers(0x00280010, 4, 5) + element(0x00280030, "DS", b"0.5\\0.6") + numbers(0x00280100, 8, 8, 7, 0)
            + element(0x7FE00010, "OW", bytes(range(20 if series else 60))))


def dicom_folder(files, directory=None):
    """As tests/fuzz/dicom_folder_fuzz.cpp takes it apart."""
    parts = [struct.pack("<H", 2 * len(file[132:])) + file[132:] for file in files]
    if directory:
        parts.append(struct.pack("<H", 2 * len(directory[132:]) + 1) + directory[132:])
    return b"".join(parts)


def dicom_samples():
    """The small ones of tests/data/dicom; those that no volume can be read of apart."""
    folder = pathlib.Path(__file__).resolve().parents[1] / "data/dicom"
    refused = {"us_film", "movie_group", "philips_native", "encapsulated_stl"}
    good, other = {}, {}
    for file in sorted(folder.glob("*.dcm")):
        contradicted = file.stem.endswith(("_other_size", "_called_8"))
        (other if contradicted or file.stem in refused else good)[file.stem] = file.read_bytes()
    return good, other, (folder / "file_set/DICOMDIR").read_bytes()


def geometry(spacing=0.5, kind=1, shift=0.0):
    """As tests/fuzz/stored_volumes.h takes it apart."""
    identity = [float(r == c) for r in range(3) for c in range(3)]
    return struct.pack("<3i15d3B", 5, 4, 3, spacing, 0.6, 0.7, shift, 0, 0, *identity, kind, 1, 1)


def volume_answer(grid=b"\0", mask=b""):
    """As core/io/reader_wire.cpp has it: what may be missing, the grid first, then the rest in its order."""
    text = b"NRRD"
    head = grid + struct.pack("<BB", 0, 0) + struct.pack("<Q", len(text)) + text
    identity = [float(r == c) for r in range(3) for c in range(3)]
    place = struct.pack("<3i3d3d9d", 4, 3, 2, 0.5, 0.5, 0.5, 0, 0, 0, *identity)
    return head + place + struct.pack("<BiiidQQQQ", 1, 1, 1, 1, 0, 0, 0, 24, 24) + VOXELS + struct.pack("<Q", len(mask)) + mask


def swept(fan, sweep):
    """As the wire has a swept grid of four samples along a beam."""
    tables = b"".join(struct.pack("<Q", len(t)) + struct.pack(f"<{len(t)}d", *t) for t in (fan, sweep))
    return struct.pack("<Bi3d", 1, 4, 20, 0.5, 8) + tables + b"\0"


# ---- volumes of scanners and other programs

def kretz(*records, magic=b"KRETZFILE 1.0   "):
    return magic + b"".join(struct.pack("<HHI", g, e, len(data)) + data for g, e, data in records)


def kretz_records(toroidal=True, volume=0, voxels=None):
    v = volume << 8
    dims = [(0xC000, v | n, struct.pack("<H", size)) for n, size in ((1, 4), (2, 3), (3, 2))]
    if not toroidal:
        return dims + [(0x0010, 0x0022, struct.pack("<d", 0.25)), (0xD000, v | 1, voxels or VOXELS)]
    right = 1.5707963267948966
    return dims + [(0xC100, v | 1, struct.pack("<d", 0.0005)), (0xC200, v | 1, struct.pack("<d", 40)),
                   (0xC200, v | 2, struct.pack("<d", -16)),
                   (0xC300, v | 1, struct.pack("<2d", right - 0.2, right + 0.2)),
                   (0xC300, v | 2, struct.pack("<3d", right - 0.3, right, right + 0.3)), (0xD000, v | 1, VOXELS)]


END = (0xFFFF, 0xFFFF, b"")
PERSON = (0x0110, 2, b"A^B")
TOSHIBA = b"""[Geometry Data]
Range = 4
Azimuth = 3
Elevation = 2
RoiAxialSpanMm = 6
AxialRoiStartMm = 50
MechRadiusMm = 20
ApexAngleAzimuthHalf = 30
ApexAngleElevationHalf = 40
Probe Type = Convex
"""
DAT = b"""ObjectFileName: a.raw
Resolution: 4 3 2
SliceThickness: 0.5 1 2
Format: UCHAR
ObjectModel: RGB
ByteOrder: big-endian
"""
VVD = b"""<?xml version="1.0" ?><VoreenData version="1"><Volumes><Volume>
<RawData filename="a.raw" format="Vector3(uint8)" x="4" y="3" z="2" /><MetaData>
<MetaItem name="Offset" type="Vec3MetaData"><value x="1" y="2" z="3" /></MetaItem>
<MetaItem name="Spacing" type="Vec3MetaData"><value x="0.5" y="1" z="2" /></MetaItem>
<MetaItem name="Transformation" type="Mat4MetaData"><value><row0 x="0" y="-1" z="0" w="9" />
<row1 x="1" y="0" z="0" w="0" /><row2 x="0" y="0" z="1" w="0" /></value></MetaItem>
</MetaData></Volume></Volumes></VoreenData>
"""


def grid(kind, lengths, tables=()):
    """As tests/fuzz/grid_fuzz.cpp takes it apart: bytes choose, one more than the least."""
    if kind == "pyramid":
        return bytes([0, 5, 6, 4]) + struct.pack("<4d", *lengths)
    counted_tables = b"".join(bytes([len(t)]) + struct.pack(f"<{len(t)}d", *t) for t in tables)
    return bytes([1, 6, kind == "parallel"]) + struct.pack("<3d", *lengths) + counted_tables


# ---- pictures, texts

def png(width, height, pixels=True):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    rows = (b"\0" + bytes(4 * width)) * height if pixels else b""
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


RECIPE = {"sonoskin": "0.1.0", "classification": {"alpha": 0.5}, "scan": {"probeSide": "i-low"},
          "mesh": {"partsCut": [[0, 0, 0], [1, 2, 3], [4, 5, 6]]}, "landmarks": {"noseTip": [1.5, -2, 30]}}
SETTINGS = {"folder": "/a", "recent": ["/a/b.nrrd", "/c"], "remembersFiles": True, "width": 1500, "height": 940,
            "skinQuality": "full"}


def corpus():
    """Of every target: good files by name, and broken ones beside those that cuts and flips of the good give."""
    text = " ".join(map(str, VOXELS)).encode()
    yield "ply", {"text": ply(""), "little": ply("<"), "big": ply(">")}, {
        "many": ply("").replace(b"vertex 4", b"vertex 99999999999"),
        "nan": ply("").replace(b"0.25", b"nan").replace(b" 1 0.5", b" inf 0.5")}
    yield "stl", {"binary": stl_binary(), "text": stl_text()}, {"many": stl_binary()[:80] + b"\xff" * 54}
    yield "obj", {"text": obj()}, {"index": obj() + b"f 99 -7 1\n"}
    yield "mesh_answer", {"whole": mesh_answer()}, {}
    yield "gltf", {"glb": glb(), "text": glb(True)}, {"many": glb().replace(b'"count": 12', b'"count": 4000000000')}
    yield "three_mf", {"model": three_mf(), "zip": zipped(three_mf("micron"))}, {
        "self": three_mf().replace(b'component objectid="1"', b'component objectid="2"')}
    offsets = vtk_surface(False).split(b"POLYGONS")[0] + (
        b"POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n0 2 1 0 1 3 0 3 2 1 2 3\n")
    yield "vtk_surface", {"text": vtk_surface(False), "binary": vtk_surface(True), "offsets": offsets}, {}
    yield "vtp", {"text": vtp(False), "packed": vtp(True)}, {}
    yield "nrrd", {"raw": nrrd("raw", VOXELS), "gzip": nrrd("gzip", gzip.compress(VOXELS, mtime=0)),
                   "text": nrrd("ascii", text), "hex": nrrd("hex", VOXELS.hex().encode()),
                   "bzip2": nrrd("bzip2", bz2.compress(VOXELS)), "units": nrrd("raw", VOXELS, 'space units: "cm" "cm" "cm"\n'),
                   "mins": nrrd("raw", VOXELS).replace(b"space: left-posterior-superior\n", b"").replace(
                       b"space directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\n", b"axis mins: 0 1 2\naxis maxs: 4 5 6\n").replace(
                       b"space origin: (0,0,0)\n", b"units: \"mm\" \"mm\" \"cm\"\n"),
                   "steps": nrrd("raw", VOXELS).replace(b"dimension: 3", b"dimension: 4").replace(b"sizes: 4 3 2", b"sizes: 4 3 2 2")
                   .replace(b"kinds: domain", b"kinds: time domain").replace(b"directions: ", b"directions: none ")
                   + VOXELS}, {
        "list": nrrd("raw", b"", "data file: LIST\na.nrrd\na.nrrd\n"), "pattern": nrrd("raw", b"", "data file: a%d.raw 1 9 1\n"),
        "outside": nrrd("raw", b"", "data file: ../b.raw\n")}
    yield "meta", {"raw": meta("", VOXELS)} | {
        "packed": meta(f"CompressedData = True\nCompressedDataSize = {len(zlib.compress(VOXELS))}\n",
                       zlib.compress(VOXELS)), "units": meta("DistanceUnits = cm\n", VOXELS)}, {"list": meta("", b"").replace(b"LOCAL", b"LIST\na\n")}
    field = b"POINT_DATA 24\nFIELD FieldData 1\ngrey 1 24 unsigned_char\n" + VOXELS
    cells = vtk("BINARY", VOXELS).replace(b"DIMENSIONS 4 3 2", b"DIMENSIONS 5 4 3").replace(b"POINT_DATA", b"CELL_DATA")
    planes = (b"DIMENSIONS 4 3 2\nX_COORDINATES 4 int\n0 1 2 3\nY_COORDINATES 3 int\n0 1 2\nZ_COORDINATES 2 int\n0 1\n")
    yield "vtk", {"binary": vtk("BINARY", VOXELS), "text": vtk("ASCII", text), "cells": cells,
                  "field": vtk("BINARY", b"").split(b"POINT_DATA")[0] + field,
                  "grid": vtk("ASCII", text).replace(b"STRUCTURED_POINTS", b"RECTILINEAR_GRID").replace(
                      b"DIMENSIONS 4 3 2\nSPACING 0.5 0.5 0.5\nORIGIN 0 0 0\n", planes)}, {}
    yield "nifti", {"plain": nifti(), "matrix": nifti(0, 1), "packed": gzip.compress(nifti(), mtime=0)}, {}
    good, other, directory = dicom_samples()
    yield "dicom", {"explicit": dicom(False), "implicit": dicom(True)} | good, other
    slices = [dicom(series=b"1.3", number=k, place=k) for k in range(4)]
    more = [dicom(series=b"1.4", number=10 + k, place=3 * k) for k in range(3)]
    yield "dicom_folder", {"series": dicom_folder(slices), "two": dicom_folder(slices + more)}, {
        "directory": dicom_folder(slices, directory), "gap": dicom_folder(slices[:2] + slices[3:]),
        "times": dicom_folder(slices + [dicom(series=b"1.3", number=20 + k, place=k) for k in range(4)])}
    yield "geometry", {"plain": geometry()}, {"far": geometry(shift=1e300), "fine": geometry(spacing=1e-300)}
    fan, sweep = [-0.3, 0, 0.3], [-0.2, 0.2]
    yield "volume_answer", {"whole": volume_answer(), "masked": volume_answer(mask=VOXELS), "swept": volume_answer(swept(fan, sweep)),
                            "pyramid": volume_answer(struct.pack("<B3i4d", 2, 4, 3, 2, 0.5, 0.5, 10, 0.5))}, {
        "turned": volume_answer(swept(fan[::-1], [0.2, 0.2]))}
    toroidal, voxels = kretz_records(), kretz_records(False)
    yield "kretz", {"toroidal": kretz(PERSON, *toroidal, END), "cartesian": kretz(*voxels, END) + b"\0",
                    "several": kretz(*toroidal, *kretz_records(True, 2)),
                    "steps": kretz(*voxels, (0xD400, 1, b"\3\0"), (0xD600, 1, 3 * VOXELS))}, {
        "packed": kretz((2, 0x1000, b"\1"), *voxels[:3], END), "long": kretz((0xC300, 1, b""), (0xD000, 1, b""))[:-4]
        + b"\xff" * 4, "other": kretz(magic=b"KRETZFILE 2.0   "), "wide": kretz(*kretz_records(False, 0, 2 * VOXELS))}
    yield "grid", {}, {"fan": grid("fan", (20, 0.5, 8), (fan, sweep)), "parallel": grid("parallel", (9, 1, -80), (fan, sweep)),
                       "pyramid": grid("pyramid", (0.6, 0.7, 9, 0.5)), "fine": grid("fan", (1e3, 1e-4, 8), (fan, sweep))}
    yield "toshiba", {"convex": TOSHIBA}, {"linear": TOSHIBA.replace(b"Convex", b"Linear").replace(b"= 20", b"= 130")}
    yield "voreen", {"dat": b"\0" + DAT, "vvd": b"\1" + VVD}, {"outside": b"\0" + DAT.replace(b"a.raw", b"../a.raw")}
    yield "mask", {"bytes": geometry() + bytes(range(60)), "float": geometry(kind=8) + bytes(range(240))}, {
        "elsewhere": geometry(shift=500) + bytes(range(60)), "fine": geometry(spacing=0.0011, shift=9e4) + b"\1" * 60}
    yield "image", {"small": png(5, 3)}, {"large": png(16384, 16384, False)}
    erased = RECIPE | {"erased": {"dims": [5, 4, 3], "counts": [10, 20, 5, 25]}}
    yield "recipe", {"some": json.dumps(RECIPE).encode(), "erased": json.dumps(erased).encode()}, {
        "ragged": b'{"erased": {"dims": [5, 4, 3], "counts": [18446744073709551615, 61]}}',
        "number": b'{"classification": {"alpha": 1e999}}', "deep": b"[" * 2000,
        "wraps": b'{"mesh": {"smooth": 4294967297}}'}
    session = {"sonoskin_session": 1, "volume": "/a.nrrd", "surface": True, "follows": False, "recipe": RECIPE,
               "views": {"cursor": [1, 2, 3], "layer": "raw", "grey": {"level": 0.5, "width": 1},
                         "slices": [{"pan": [1, 2], "zoom": 2}] * 3, "maximised": "space",
                         "camera": {"forward": [0, 1, 0], "up": [0, 0, 1], "distance": 90}}}
    yield "session", {"whole": json.dumps(session).encode()}, {
        "deep": b'{"sonoskin_session": 1, "views": {"a": ' + b"[" * 2000,
        "numbers": json.dumps(session | {"views": {"grey": {"width": -1e300}, "brushRadius": 1e308}}).encode()}
    yield "landmarks", {"some": b"landmarks.noseTip=1.5,-2,30\nlandmarks.mouthLeft=1,2,3\nclassification.alpha=0.7"}, {
        "nan": b"landmarks.noseTip=nan,inf,1\nlandmarks.leftEye=1,2\nlandmarks.rightEye=1,2,3,4"}
    yield "settings", {"whole": json.dumps(SETTINGS).encode()}, {
        "kind": b'{"width": "wide", "recent": [1, {}]}', "enormous": b'{"width": 555155555555555555555551111110911105}'}
    yield "journal", {"whole": b"+a\n+d\n-c\n"}, {
        "outside": b"+../outside\n-../outside\n-.\n-..\n+/\n", "own": b"-.sonoskin-publish\n+.sonoskin-list\n"}


def main():
    for target, good, other in corpus():
        folder = pathlib.Path(sys.argv[1]) / target
        folder.mkdir(parents=True, exist_ok=True)
        for name, data in good.items():
            (folder / f"good_{name}").write_bytes(data)
        for name, data in other.items():
            (folder / f"other_{name}").write_bytes(data)
        for name, data in (good | other).items():
            for fault, damaged in broken(data):
                (folder / f"{fault}_{name}").write_bytes(damaged)


if __name__ == "__main__":
    main()
