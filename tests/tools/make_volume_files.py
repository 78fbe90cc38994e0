#!/usr/bin/env python3
"""make_volume_files.py FOLDER: writes small volumes in many dialects of NRRD, MetaImage, NIfTI and VTK legacy into FOLDER, and
what is true of each into FOLDER/truth.json, for tests/core/volume_files_test.cpp. The headers are written by hand, from what the
formats' pages say; where Python has VTK, its writers add files of theirs, those named vtk_lib_*. The same files each time."""
import bz2
import gzip
import json
import pathlib
import struct
import sys
import zlib

import numpy as np

DIMS = (5, 4, 3)
FOLDER = pathlib.Path(sys.argv[1])
TRUTH = []
RANDOM = np.random.default_rng(18)


def rotation():
    q, r = np.linalg.qr(RANDOM.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else q * [[1, 1, -1]]


def place(mirrored=False, turned=True):
    """Origin, spacing and direction (axes as columns) in mm and LPS."""
    direction = rotation() if turned else np.eye(3)
    if mirrored:
        direction = direction * [[1, 1, -1]]
    return {"origin": RANDOM.uniform(-80, 80, 3).round(3), "spacing": RANDOM.uniform(0.2, 1.5, 3).round(3),
            "direction": direction}


def voxels(step=0, dtype=np.uint8):
    """Every voxel and every step has a value of its own; as k, j, i."""
    k, j, i = np.meshgrid(*[np.arange(n) for n in reversed(DIMS)], indexing="ij")
    return (1 + i + 5 * j + 20 * k + 60 * step).astype(dtype)


def truth(name, p, known=True, steps=1, seconds=0.0, dims=DIMS, components=1, scale=(1, 0), warned=False):
    TRUTH.append({"file": name, "dims": list(dims), "origin": list(map(float, p["origin"])),
                  "spacing": list(map(float, p["spacing"])), "direction": np.asarray(p["direction"]).T.tolist(),
                  "known": known, "steps": steps, "seconds": seconds, "components": components,
                  "scale": list(scale), "warned": warned})


def put(name, *parts):
    (FOLDER / name).write_bytes(b"".join(p.encode() if isinstance(p, str) else p for p in parts))


# ---- NRRD

SIGNS = {"right-anterior-superior": (-1, -1, 1), "RAS": (-1, -1, 1), "left-anterior-superior": (1, -1, 1), "LAS": (1, -1, 1),
         "left-posterior-superior": (1, 1, 1), "LPS": (1, 1, 1), "scanner-xyz": (1, 1, 1), "3D-right-handed": (1, 1, 1),
         "3D-left-handed": (1, -1, 1)}


def vector(v):
    return "(" + ",".join(repr(float(x)) for x in v) + ")"


def directions(p, signs=(1, 1, 1), unit=1.0, extra=()):
    return [vector([*(np.array(signs) * p["direction"][:, a] * p["spacing"][a] / unit), *extra]) for a in range(3)]


def nrrd(name, lines, data, sizes=DIMS, typ="uint8", encoding="raw"):
    sizes = " ".join(map(str, sizes))
    put(name, f"NRRD0005\n# made by hand\ntype: {typ}\ndimension: {len(sizes.split())}\nsizes: {sizes}\n"
              f"encoding: {encoding}\n" + "".join(line + "\n" for line in lines) + "\n", data)


def placed(p, space="left-posterior-superior", unit=1.0, units=None):
    signs = SIGNS[space]
    lines = [f"space: {space}", "space directions: " + " ".join(directions(p, signs, unit)),
             "space origin: " + vector(np.array(signs) * p["origin"] / unit)]
    return lines + ([f"space units: " + " ".join(f'"{units}"' for _ in range(3))] if units else [])


def nrrd_spaces():
    for n, space in enumerate(SIGNS):
        for mirrored in (False, True):
            p, name = place(mirrored), f"nrrd_{space}_{'mirrored' if mirrored else 'straight'}.nrrd"
            nrrd(name, placed(p, space), voxels().tobytes())
            truth(name, p, warned=space == "3D-left-handed")
    for space in ("right-anterior-superior-time", "LAST", "left-posterior-superior-time", "scanner-xyz-time",
                  "3D-right-handed-time", "3D-left-handed-time"):
        signs = SIGNS.get(space.removesuffix("-time"), (1, -1, 1))
        p, name = place(), f"nrrd_{space}.nrrd"
        nrrd(name, [f"space: {space}", "kinds: domain domain domain time", 'space units: "mm" "mm" "mm" "ms"',
                    "space directions: " + " ".join(directions(p, signs, extra=(0,))) + " (0,0,0,40)",
                    "space origin: " + vector([*(np.array(signs) * p["origin"]), 0])],
             voxels().tobytes() + voxels(1).tobytes(), (*DIMS, 2))
        truth(name, p, steps=2, seconds=0.04, warned="left-handed" in space)
    p = place()
    nrrd("nrrd_space_dimension.nrrd", ["space dimension: 3", *placed(p)[1:]], voxels().tobytes())
    truth("nrrd_space_dimension.nrrd", p, warned=True)


def nrrd_units():
    for unit, mm in {"m": 1000, "cm": 10, "mm": 1, "um": 1e-3, "µm": 1e-3, "micron": 1e-3, "inches": 25.4}.items():
        p, name = place(), f"nrrd_space_units_{unit.replace('µ', 'micro_')}.nrrd"
        nrrd(name, placed(p, "right-anterior-superior", mm, unit), voxels().tobytes())
        truth(name, p)
    p = place()
    nrrd("nrrd_space_units_unknown.nrrd", placed(p, "LPS", 1, "cubits"), voxels().tobytes())
    truth("nrrd_space_units_unknown.nrrd", p, warned=True)
    p = {"origin": np.zeros(3), "spacing": np.array([0.5, 6, 0.7]), "direction": np.eye(3)}
    nrrd("nrrd_axis_units.nrrd", ["spacings: 0.5 0.6 0.0007", 'units: "mm" "cm" "m"'], voxels().tobytes())
    truth("nrrd_axis_units.nrrd", p)


def nrrd_ranges():
    p = {"origin": np.array([-10.0, 20.0, 5.0]), "spacing": np.array([0.5, 0.25, 2.0]), "direction": np.eye(3)}
    cell_min, node_max = p["origin"] - p["spacing"] / 2, p["origin"] + p["spacing"] * (np.array(DIMS) - 1)
    text = lambda v: " ".join(repr(float(x)) for x in v)
    cell = [f"axis mins: {text(cell_min)}", f"axis maxs: {text(cell_min + p['spacing'] * DIMS)}"]
    node = [f"axis mins: {text(p['origin'])}", f"axis maxs: {text(node_max)}"]
    for name, lines, warned in (("cells", [*cell, "centers: cell cell cell"], False),
                                ("nodes", [*node, "centerings: node node node"], False),
                                ("unsaid", cell, True),
                                ("spaced_cells", [*cell, f"spacings: {text(p['spacing'])}"], False),
                                ("spaced_nodes", [*node, f"spacings: {text(p['spacing'])}"], False),
                                ("mins", [cell[0], f"spacings: {text(p['spacing'])}", "centers: cell cell cell"], False)):
        nrrd(f"nrrd_range_{name}.nrrd", lines, voxels().tobytes())
        truth(f"nrrd_range_{name}.nrrd", p, warned=warned)
    p = {"origin": np.zeros(3), "spacing": np.array([0.5, 0.25, 2.0]), "direction": np.diag([1.0, -1, 1])}
    nrrd("nrrd_spacing_negative.nrrd", ["spacings: 0.5 -0.25 2"], voxels().tobytes())
    truth("nrrd_spacing_negative.nrrd", p)
    p = {"origin": np.zeros(3), "spacing": np.ones(3), "direction": np.eye(3)}
    nrrd("nrrd_unspaced.nrrd", [], voxels().tobytes())
    truth("nrrd_unspaced.nrrd", p, known=False)


def nrrd_kinds():
    steps = np.stack([voxels(0), voxels(1)])  # t k j i
    for at in range(4):  # where time stands, from the fastest on
        p, name = place(), f"nrrd_time_at_{at}.nrrd"
        order = np.moveaxis(steps, 0, 3 - at)
        kinds, sizes, axes = ["domain"] * 3, list(DIMS), directions(p)
        kinds.insert(at, "time"), sizes.insert(at, 2), axes.insert(at, "none")
        spacings = " ".join("0.25" if n == at else "nan" for n in range(4))
        units = " ".join('"s"' if n == at else '""' for n in range(4))
        nrrd(name, ["space: LPS", "kinds: " + " ".join(kinds), "space directions: " + " ".join(axes),
                    "space origin: " + vector(p["origin"]), f"spacings: {spacings}", f"units: {units}"],
             np.ascontiguousarray(order).tobytes(), sizes)
        truth(name, p, steps=2, seconds=0.25)
    for kind, count in (("RGB-color", 3), ("3-color", 3), ("RGBA-color", 4)):
        for at in (0, 3):
            p, name = place(), f"nrrd_{kind}_at_{at}.nrrd"
            colours = np.moveaxis(np.stack([voxels()] * count), 0, 3 - at)
            kinds, sizes, axes = ["space"] * 3, list(DIMS), directions(p)
            kinds.insert(at, kind), sizes.insert(at, count), axes.insert(at, "none")
            nrrd(name, ["space: LPS", "kinds: " + " ".join(kinds), "space directions: " + " ".join(axes),
                        "space origin: " + vector(p["origin"])], np.ascontiguousarray(colours).tobytes(), sizes)
            truth(name, p, components=count)
    p = place()
    nrrd("nrrd_one_more_axis.nrrd", ["space: LPS", "kinds: list domain domain domain",
                                     "space directions: none " + " ".join(directions(p)),
                                     "space origin: " + vector(p["origin"])], voxels().tobytes(), (1, *DIMS))
    truth("nrrd_one_more_axis.nrrd", p)


def nrrd_encodings():
    p = place()
    data, words = voxels().tobytes(), " ".join(map(str, voxels().ravel())).encode()
    big = voxels(0, ">i2").tobytes()
    for name, encoding, lines, body, typ in (
            ("gzip", "gzip", [], gzip.compress(data, mtime=0), "uint8"),
            ("gz_skipping", "gz", ["byte skip: 7"], gzip.compress(b"7 bytes" + data, mtime=0), "uint8"),
            ("bzip2", "bzip2", [], bz2.compress(data), "uint8"), ("bz2", "bz2", [], bz2.compress(data), "uint8"),
            ("hex", "hex", [], data.hex(" ", 9).encode(), "uint8"),
            ("hex_big", "hex", ["endian: big"], big.hex().upper().encode(), "int16"),
            ("ascii", "ascii", [], words, "uint8"), ("txt_float", "txt", [], words, "float"),
            ("big", "raw", ["endian: big"], big, "short"),
            ("lines", "raw", ["line skip: 2"], b"a line\nanother\n" + data, "uint8"),
            ("skipping", "raw", ["byte skip: 5"], b"5 by." + data, "uint8"),
            ("lines_gzip", "gzip", ["line skip: 1"], b"a line\n" + gzip.compress(data, mtime=0), "uint8"),
            ("last_bytes", "raw", ["byte skip: -1"], b"whatever stands before" + data, "uint8")):
        name = f"nrrd_encoding_{name}.nrrd"
        nrrd(name, [*placed(p), *lines], body, typ=typ, encoding=encoding)
        truth(name, p)
    note = "long words in a comment; " * 40
    nrrd("nrrd_long_lines.nrrd", [f"# {note}", f"content: {note}", f"key of a scanner:={note}", *placed(p)], data)
    truth("nrrd_long_lines.nrrd", p)


def nrrd_files():
    p = place()
    slices = [voxels()[k].tobytes() for k in range(3)]
    for k in range(3):
        put(f"slice_{k + 1:03d}.raw", slices[k])
        put(f"slice_{k + 1:03d}.gz", gzip.compress(slices[k], mtime=0))
    put("whole.raw", b"head" + voxels().tobytes()), put("steps_0.raw", voxels().tobytes()), put("steps_1.raw", voxels(1).tobytes())
    for name, lines, encoding in (
            ("detached", ["byte skip: -1", "data file: whole.raw"], "raw"),
            ("pattern", ["data file: slice_%03d.raw 1 3 1"], "raw"), ("pattern_subdim", ["data file: slice_%03d.gz 1 3 1 2"], "gzip"),
            ("list", ["data file: LIST", *(f"slice_{k}.raw" for k in ("001", "002", "003"))], "raw")):
        nrrd(f"nrrd_files_{name}.nhdr", [*placed(p), *lines], b"", encoding=encoding)
        truth(f"nrrd_files_{name}.nhdr", p)
    nrrd("nrrd_files_slabs.nhdr", ["kinds: space space space time", *placed(p)[:1], "space directions: " + " ".join(directions(p)) + " none",
                                   *placed(p)[2:], "data file: LIST 4", "steps_0.raw", "steps_1.raw"], b"", (*DIMS, 2))
    truth("nrrd_files_slabs.nhdr", p, steps=2)


# ---- MetaImage

def meta(name, lines, data, dims=DIMS, typ="MET_UCHAR", file="LOCAL"):
    put(name, f"ObjectType = Image\nNDims = {len(dims)}\nBinaryData = True\n" + "".join(f"{line}\n" for line in lines)
        + "DimSize = " + " ".join(map(str, dims)) + f"\nElementType = {typ}\nElementDataFile = {file}\n", data)


def meta_place(p, unit=1.0, names=("TransformMatrix", "Offset", "ElementSpacing")):
    row = lambda v: " ".join(repr(float(x)) for x in v)
    return [f"{names[0]} = {row(np.asarray(p['direction']).T.ravel())}", f"{names[1]} = {row(p['origin'] / unit)}",
            f"{names[2]} = {row(p['spacing'] / unit)}"]


def metas():
    data = voxels().tobytes()
    for n in range(6):
        p = place(mirrored=n % 2 == 1)
        meta(f"meta_turned_{n}.mha", meta_place(p), data)
        truth(f"meta_turned_{n}.mha", p)
    for unit, mm in {"m": 1000, "cm": 10, "mm": 1, "um": 1e-3, "inches": 25.4}.items():
        p = place()
        meta(f"meta_units_{unit}.mha", [*meta_place(p, mm), f"DistanceUnits = {unit}"], data)
        truth(f"meta_units_{unit}.mha", p)
    p = place(turned=False)
    for name, lines, body, warned in (
            ("rotation_position", meta_place(p, 1, ("Rotation", "Position", "ElementSize")), data, False),
            ("orientation_origin", meta_place(p, 1, ("Orientation", "Origin", "ElementSpacing")), data, False),
            ("rai", [*meta_place(p), "AnatomicalOrientation = RAI"], data, False),
            ("lpi", [*meta_place(p), "AnatomicalOrientation = LPI"], data, True),
            ("long_lines", [*meta_place(p), "Comment = " + "made by a reconstruction; " * 40, "0010|0010 = X"], data, False),
            ("packed", [*meta_place(p), "CompressedData = True", f"CompressedDataSize = {len(zlib.compress(data))}"], zlib.compress(data), False),
            ("packed_unsaid", [*meta_place(p), "CompressedData = True"], zlib.compress(data), False),
            ("last_bytes", [*meta_place(p), "HeaderSize = -1"], b"something else" + data, False),
            ("size_and_spacing", [*meta_place(p), "ElementSize = 9 9 9"], data, False)):
        meta(f"meta_{name}.mha", lines, body)
        truth(f"meta_{name}.mha", p, warned=warned)
    meta("meta_big.mha", [*meta_place(p), "ElementByteOrderMSB = True"], voxels(0, ">i2").tobytes(), typ="MET_SHORT")
    truth("meta_big.mha", p)
    meta("meta_big_and_not.mha", [*meta_place(p), "BinaryDataByteOrderMSB = False", "ElementByteOrderMSB = True"],
         voxels(0, ">i2").tobytes(), typ="MET_SHORT")
    truth("meta_big_and_not.mha", p, warned=True)
    meta("meta_text.mha", [line for line in meta_place(p)] + ["BinaryDataByteOrderMSB = False"], b"")
    text = (FOLDER / "meta_text.mha").read_text().replace("BinaryData = True", "BinaryData = False")
    put("meta_text.mha", text, " ".join(map(str, voxels().ravel())))
    truth("meta_text.mha", p)
    meta("meta_slope.mha", [*meta_place(p), "ElementToIntensityFunctionSlope = -2", "ElementToIntensityFunctionOffset = 500"], data)
    truth("meta_slope.mha", p, scale=(-2, 500))
    meta("meta_header_size.mhd", [*meta_place(p), "HeaderSize = 4"], b"", file="whole.raw")
    truth("meta_header_size.mhd", p)
    meta("meta_pattern.mhd", meta_place(p), b"", file="slice_%03d.raw 1 3 1")
    truth("meta_pattern.mhd", p)
    meta("meta_list.mhd", meta_place(p), b"slice_001.raw\nslice_002.raw\nslice_003.raw\n", file="LIST")
    truth("meta_list.mhd", p)
    spread = np.eye(4)
    spread[:3, :3] = p["direction"]
    meta("meta_steps.mha", ["TransformMatrix = " + " ".join(map(str, spread.T.ravel())), "Offset = " + " ".join(map(str, p["origin"])) + " 0",
                            "ElementSpacing = " + " ".join(map(str, p["spacing"])) + " 1"], data + voxels(1).tobytes(), (*DIMS, 2))
    truth("meta_steps.mha", p, steps=2)
    meta("meta_unspaced.mha", [], data)
    truth("meta_unspaced.mha", {"origin": np.zeros(3), "spacing": np.ones(3), "direction": np.eye(3)}, known=False)


# ---- NIfTI

def quaternion(m):
    """Of a rotation: b, c, d with a >= 0 [Shepperd 1978]."""
    w = np.sqrt(max(0, 1 + np.trace(m))) / 2
    if w > 1e-3:
        return np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / (4 * w)
    values, vectors = np.linalg.eigh((m + m.T) / 2)
    return vectors[:, np.argmax(values)]


def nifti(name, p, q=0, s=0, units=2, order="<", data=None, steps=1, version=1, two=False, slope=(0, 0), unit=1.0, code=2,
          pixdim=None, srow=None, step=0.0):
    flip = np.diag([-1.0, -1, 1])
    affine = flip @ p["direction"] @ np.diag(p["spacing"]) / unit
    origin = flip @ p["origin"] / unit
    rotated = flip @ p["direction"]
    qfac = 1.0 if np.linalg.det(rotated) > 0 else -1.0
    b = quaternion(rotated * [[1, 1, qfac]])
    sizes = [4 if steps > 1 else 3, *DIMS, steps, 1, 1, 1]
    pix = [qfac, *(p["spacing"] / unit), step, 0, 0, 0] if pixdim is None else pixdim
    rows = np.column_stack([affine, origin]) if srow is None else srow
    if version == 1:
        h = bytearray(348)
        struct.pack_into(order + "i", h, 0, 348)
        struct.pack_into(order + "8h", h, 40, *sizes)
        struct.pack_into(order + "2h", h, 70, code, {2: 8, 4: 16, 16: 32}[code])
        struct.pack_into(order + "8f", h, 76, *pix)
        struct.pack_into(order + "3f", h, 108, 0 if two else 352, *slope)
        h[123] = units
        struct.pack_into(order + "2h", h, 252, q, s)
        struct.pack_into(order + "6f", h, 256, *b, *origin)
        struct.pack_into(order + "12f", h, 280, *rows.ravel())
        h[344:348] = b"ni1\0" if two else b"n+1\0"
        h += bytes(0 if two else 4)
    else:
        h = bytearray(540)
        struct.pack_into(order + "i", h, 0, 540)
        h[4:12] = b"n+2\0\r\n\x1a\n"
        struct.pack_into(order + "2h8q", h, 12, code, {2: 8, 4: 16, 16: 32}[code], *sizes)
        struct.pack_into(order + "8dq2d", h, 104, *pix, 544, *slope)
        struct.pack_into(order + "2i6d12d", h, 344, q, s, *b, *origin, *rows.ravel())
        struct.pack_into(order + "i", h, 500, units)
        h += bytes(4)
    body = data if data is not None else b"".join(voxels(t).tobytes() for t in range(steps))
    if two:
        put(name, bytes(h)), put(name.replace(".hdr", ".img"), body)
    elif name.endswith(".gz"):
        put(name, gzip.compress(bytes(h) + body, mtime=0))
    else:
        put(name, bytes(h) + body)


def niftis():
    for n in range(4):
        for form in ("q", "s", "both"):
            p, name = place(mirrored=n % 2 == 1), f"nifti_{form}_{n}.nii"
            nifti(name, p, q=int(form != "s"), s=2 * int(form != "q"))
            truth(name, p)
    for units, unit, label in ((1, 1000.0, "metres"), (3, 1e-3, "microns")):
        for form in ("q", "s"):
            p, name = place(), f"nifti_{label}_{form}.nii"
            nifti(name, p, q=int(form == "q"), s=int(form == "s"), units=units, unit=unit)
            truth(name, p)
    p = place()
    nifti("nifti_big.nii", p, q=1, order=">", code=4, data=voxels(0, ">i2").tobytes()), truth("nifti_big.nii", p)
    nifti("nifti_packed.nii.gz", p, s=1), truth("nifti_packed.nii.gz", p)
    nifti("nifti_pair.hdr", p, q=1, two=True), truth("nifti_pair.hdr", p)
    nifti("nifti_2.nii", p, s=1, version=2), truth("nifti_2.nii", p)
    nifti("nifti_2_big.nii", p, q=1, version=2, order=">"), truth("nifti_2_big.nii", p)
    nifti("nifti_slope.nii", p, q=1, slope=(3, -20)), truth("nifti_slope.nii", p, scale=(3, -20))
    nifti("nifti_steps_ms.nii", p, s=1, steps=3, units=2 | 16, step=40), truth("nifti_steps_ms.nii", p, steps=3, seconds=0.04)
    nifti("nifti_steps_s.nii", p, q=1, steps=2, units=2 | 8, step=0.5), truth("nifti_steps_s.nii", p, steps=2, seconds=0.5)
    nifti("nifti_pixdim_differs.nii", p, s=1, pixdim=[1, 1, 1, 1, 0, 0, 0, 0]), truth("nifti_pixdim_differs.nii", p, warned=True)
    nifti("nifti_unit_unsaid.nii", p, s=1, units=0), truth("nifti_unit_unsaid.nii", p, warned=True)
    pix = [np.sign(np.linalg.det(p["direction"])), *-p["spacing"], 0, 0, 0, 0]
    nifti("nifti_pixdim_negative.nii", p, q=1, pixdim=pix), truth("nifti_pixdim_negative.nii", p, warned=True)
    q = place()
    rows = np.column_stack([np.diag([-1.0, -1, 1]) @ p["direction"] @ np.diag(p["spacing"]), np.diag([-1.0, -1, 1]) @ q["origin"]])
    nifti("nifti_forms_differ.nii", p, q=1, s=1, srow=rows), truth("nifti_forms_differ.nii", dict(p, origin=q["origin"]), warned=True)
    r = {"origin": np.zeros(3), "spacing": p["spacing"], "direction": np.diag([-1.0, -1, 1])}
    nifti("nifti_pixdim_alone.nii", p), truth("nifti_pixdim_alone.nii", r, warned=True)
    nifti("nifti_unspaced.nii", p, q=1, pixdim=[1] + [0] * 7)
    qfac = np.linalg.det(np.diag([-1.0, -1, 1]) @ p["direction"])
    assert qfac > 0
    truth("nifti_unspaced.nii", dict(p, spacing=np.ones(3)), known=False)


# ---- VTK legacy

def vtk(name, lines, form="BINARY", title="made by hand"):
    put(name, f"# vtk DataFile Version 4.2\n{title}\n{form}\n", *[p for line in lines for p in (line, "\n")])


def vtk_grid(p, points=DIMS):
    row = lambda v: " ".join(repr(float(x)) for x in v)
    return ["DATASET STRUCTURED_POINTS", "DIMENSIONS " + " ".join(map(str, points)), f"SPACING {row(p['spacing'])}", f"ORIGIN {row(p['origin'])}"]


def vtks():
    p = place(turned=False)
    n, data, words = 60, voxels().tobytes(), " ".join(map(str, voxels().ravel()))
    scalars, table = ["SCALARS grey unsigned_char 1", "LOOKUP_TABLE default"], "LOOKUP_TABLE default"
    short = voxels(0, ">i2").tobytes()
    vectors = np.zeros((n, 3), ">f4").tobytes()
    field = ["FIELD FieldData 2", "time 1 1 double", struct.pack(">d", 3.5), f"grey 1 {n} short", short]
    names = ["METADATA", "COMPONENT_NAMES", "grey", ""]
    for name, lines, form in (
            ("binary", [f"POINT_DATA {n}", *scalars, data], "BINARY"), ("ascii", [f"POINT_DATA {n}", *scalars, words], "ASCII"),
            ("no_table", [f"POINT_DATA {n}", scalars[0], data], "BINARY"),
            ("table_after", [f"POINT_DATA {n}", "SCALARS grey unsigned_char", "LOOKUP_TABLE mine", data, "LOOKUP_TABLE mine 2", bytes(8)], "BINARY"),
            ("field", [f"POINT_DATA {n}", *field], "BINARY"),
            ("metadata", [f"POINT_DATA {n}", *scalars, data, *names], "BINARY")):
        vtk(f"vtk_{name}.vtk", [*vtk_grid(p), *lines], form)
        truth(f"vtk_{name}.vtk", p)
    vtk("vtk_metadata_first.vtk", [*vtk_grid(p)[:1], *field[:1], "time 1 1 double", struct.pack(">d", 1), *names, "steps 1 1 int", struct.pack(">i", 1),
                                   *vtk_grid(p)[1:], f"POINT_DATA {n}", *scalars, data])
    truth("vtk_metadata_first.vtk", p)
    vtk("vtk_several.vtk", [*vtk_grid(p), f"POINT_DATA {n}", "VECTORS flow float", vectors, "SCALARS grey short", table, short,
                            "NORMALS n float", vectors])
    truth("vtk_several.vtk", p, warned=True)
    vtk("vtk_long_title.vtk", [*vtk_grid(p), f"POINT_DATA {n}", *scalars, data], title="a long title " * 40)
    truth("vtk_long_title.vtk", p)
    vtk("vtk_colours.vtk", [*vtk_grid(p), f"POINT_DATA {n}", "COLOR_SCALARS rgb 3", np.repeat(voxels().ravel(), 3).tobytes()])
    truth("vtk_colours.vtk", p, components=3)
    cells = dict(p, origin=p["origin"] - p["spacing"] / 2)
    vtk("vtk_cells.vtk", [*vtk_grid(cells, [d + 1 for d in DIMS]), f"CELL_DATA {n}", *scalars, data])
    truth("vtk_cells.vtk", p)
    vtk("vtk_cells_and_points.vtk", [*vtk_grid(p), "CELL_DATA 24", "SCALARS other unsigned_char", table, bytes(24), f"POINT_DATA {n}", *scalars, data])
    truth("vtk_cells_and_points.vtk", p, warned=True)
    at = [p["origin"][a] + p["spacing"][a] * np.arange(DIMS[a]) for a in range(3)]
    grid = ["DATASET RECTILINEAR_GRID", "DIMENSIONS 5 4 3"]
    for a in range(3):
        grid += [f"{'XYZ'[a]}_COORDINATES {DIMS[a]} double", at[a].astype(">f8").tobytes()]
    vtk("vtk_rectilinear.vtk", [*grid, f"POINT_DATA {n}", *scalars, data])
    truth("vtk_rectilinear.vtk", p)


def by_vtk():
    """What VTK's own writers make of the same voxels."""
    import vtk as library
    from vtk.util.numpy_support import numpy_to_vtk
    p = place(turned=False)
    image = library.vtkImageData()
    image.SetDimensions(*DIMS), image.SetSpacing(*p["spacing"]), image.SetOrigin(*p["origin"])
    image.GetPointData().SetScalars(numpy_to_vtk(voxels().ravel(), deep=True))
    image.GetPointData().GetScalars().SetName("grey")
    for version, ascii_too in ((42, False), (51, False), (51, True)):
        writer = library.vtkStructuredPointsWriter()
        name = f"vtk_lib_{version}_{'ascii' if ascii_too else 'binary'}.vtk"
        writer.SetFileName(str(FOLDER / name)), writer.SetInputData(image), writer.SetFileVersion(version)
        writer.SetFileTypeToASCII() if ascii_too else writer.SetFileTypeToBinary()
        writer.Write()
        truth(name, p)
    p = place()
    writer = library.vtkNIFTIImageWriter()
    form = library.vtkMatrix4x4()
    rows = np.column_stack([np.diag([-1.0, -1, 1]) @ p["direction"], np.diag([-1.0, -1, 1]) @ p["origin"]])
    for r in range(3):
        for c in range(4):
            form.SetElement(r, c, rows[r, c])
    image.SetOrigin(0, 0, 0), image.SetSpacing(*p["spacing"])
    for which in ("Q", "S"):
        writer = library.vtkNIFTIImageWriter()
        name = f"vtk_lib_{which}form.nii"
        writer.SetFileName(str(FOLDER / name)), writer.SetInputData(image)
        getattr(writer, f"Set{which}FormMatrix")(form)
        writer.SetQFac(1.0)
        writer.Write()
        truth(name, p, warned=True)  # it does not write the unit


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for make in (nrrd_spaces, nrrd_units, nrrd_ranges, nrrd_kinds, nrrd_encodings, nrrd_files, metas, niftis, vtks):
        make()
    try:
        by_vtk()
    except ImportError:
        sys.exit("make_volume_files: Python has no VTK, whose files are missing now")
    rows = ",\n".join(json.dumps(row) for row in TRUTH)
    (FOLDER / "truth.json").write_text(f"[\n{rows}\n]\n")


if __name__ == "__main__":
    main()
