"""Readers of volumes and meshes that share no code with the program, for read_table.py; what each says is a dict. Parsers written
here (NRRD, MetaImage, NIfTI, VTK, Kretz, GLB, 3MF, STL, PLY, OBJ), and pydicom for DICOM."""
import gzip
import json
import re
import struct
import zipfile
import xml.etree.ElementTree as xml

import numpy as np

FLIP = np.diag([-1.0, -1.0, 1.0])  # RAS to LPS and back
UNITS = {"m": 1000, "meter": 1000, "meters": 1000, "cm": 10, "mm": 1, "um": 0.001, "µm": 0.001, "micron": 0.001,
         "inch": 25.4, "foot": 304.8, "millimeter": 1, "millimeters": 1, "centimeter": 10, "": 1}


def facts(dims, columns, origin, unit=1.0, steps=1, known=True, frame="LPS"):
    """Of a volume: spacing and direction from the columns of the index-to-world matrix."""
    columns = np.array(columns, float) * unit
    spacing = np.linalg.norm(columns, axis=0)
    return {"dims": [int(d) for d in dims], "spacing": spacing.tolist(), "origin": (np.array(origin) * unit).tolist(),
            "axes": (columns / np.where(spacing > 0, spacing, 1)).T.tolist(), "steps": int(steps), "known": known,
            "frame": frame}


# ---- volumes

def nrrd(path):
    head = path.read_bytes()[:1 << 20].split(b"\n\n")[0].split(b"\r\n\r\n")[0].decode("latin-1").replace("\r", "")
    fields = {}
    for line in head.split("\n")[1:]:
        if ":=" not in line and ":" in line and not line.startswith("#"):
            key, value = line.split(":", 1)
            fields[key.strip().lower().replace(" ", "")] = value.strip()
    sizes = [int(s) for s in fields["sizes"].split()]
    kinds = fields.get("kinds", "").split() or ["?"] * len(sizes)
    directions = re.findall(r"none|\([^)]*\)", fields.get("spacedirections", ""))
    vectors = [None if d == "none" else [float(x) for x in d[1:-1].split(",")] for d in directions]
    spatial = [i for i, v in enumerate(vectors) if v is not None] if vectors else [
        i for i, k in enumerate(kinds) if k in ("space", "domain", "?")][:3]
    rest = [i for i in range(len(sizes)) if i not in spatial]
    if kinds[:3] == ["domain", "domain", "list"]:
        raise ValueError("a list of pictures, no volume")
    units = re.findall(r'"([^"]*)"', fields.get("spaceunits", "")) or re.findall(r'"([^"]*)"', fields.get("units", ""))
    unit = UNITS.get(units[0].strip(), None) if units else 1
    space = fields.get("space", "")
    known = bool(vectors) or "spacings" in fields or "axismins" in fields
    if vectors:
        columns = np.array([vectors[i] for i in spatial]).T
    elif "spacings" in fields:
        columns = np.diag([abs(float(fields["spacings"].split()[i])) for i in spatial])
    elif "axismins" in fields:
        low, high = ([float(x) for x in fields[k].split()] for k in ("axismins", "axismaxs"))
        cell = "cell" in fields.get("centers", fields.get("centerings", ""))
        columns = np.diag([abs(high[i] - low[i]) / (sizes[i] - (0 if cell else 1)) for i in spatial])
    else:
        columns = np.eye(3)
    origin = [float(x) for x in fields["spaceorigin"].strip("()").split(",")] if "spaceorigin" in fields else [0, 0, 0]
    turn = np.eye(3)
    words = {"r": (0, -1), "l": (0, 1), "a": (1, -1), "p": (1, 1), "s": (2, 1), "i": (2, -1)}
    letters = [w[0] for w in space.lower().split("-")] if "-" in space and "handed" not in space else list(space.lower())
    if len(letters) >= 3 and all(w in words for w in letters[:3]):
        turn = np.zeros((3, 3))
        for axis, letter in enumerate(letters[:3]):
            turn[words[letter][0], axis] = words[letter][1]
    steps = int(np.prod([sizes[i] for i in rest if kinds[i] in ("time", "list", "?", "domain")])) if rest else 1
    return facts([sizes[i] for i in spatial], turn @ columns, turn @ np.array(origin), unit or 1, steps, known, space or "none")


def meta(path):
    fields = {}
    for line in path.read_bytes()[:1 << 22].split(b"ElementDataFile")[0].decode("latin-1").splitlines():
        if "=" in line:
            key, value = line.split("=", 1)
            fields[key.strip()] = value.strip()
    if "list" in fields.get("Kinds", "").split()[2:]:
        raise ValueError("a list of pictures, no volume")
    dims = [int(x) for x in fields["DimSize"].split()]
    numbers = lambda keys, default: next(([float(x) for x in fields[k].split()] for k in keys if k in fields), default)
    n = len(dims)
    matrix = np.array(numbers(("TransformMatrix", "Rotation", "Orientation"), np.eye(n).ravel())).reshape(n, n)[:3, :3]
    spacing = numbers(("ElementSpacing", "ElementSize"), [1] * n)[:3]
    origin = numbers(("Offset", "Origin", "Position"), [0] * n)[:3]
    unit = UNITS.get(fields.get("DistanceUnits", "").lower(), 1)
    return facts(dims[:3], matrix.T @ np.diag(spacing), origin, unit, np.prod(dims[3:] or [1]),
                 "ElementSpacing" in fields or "ElementSize" in fields)


def nifti(path):
    data = path.read_bytes()
    data = gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
    end = "<" if struct.unpack_from("<i", data)[0] in (348, 540) else ">"
    dim = struct.unpack_from(end + "8h", data, 40)
    pixdim = struct.unpack_from(end + "8f", data, 76)
    units = {1: 1000, 2: 1, 3: 0.001}.get(data[123] & 7, 1)
    qform, sform = struct.unpack_from(end + "2h", data, 252)
    if sform > 0:
        affine = np.array(struct.unpack_from(end + "12f", data, 280)).reshape(3, 4)
    elif qform > 0:
        b, c, d, x, y, z = struct.unpack_from(end + "6f", data, 256)
        a = np.sqrt(max(0.0, 1 - b * b - c * c - d * d))
        turn = np.array([[a*a+b*b-c*c-d*d, 2*(b*c-a*d), 2*(b*d+a*c)], [2*(b*c+a*d), a*a+c*c-b*b-d*d, 2*(c*d-a*b)],
                         [2*(b*d-a*c), 2*(c*d+a*b), a*a+d*d-b*b-c*c]])
        scale = np.array(pixdim[1:4]) * [1, 1, -1 if pixdim[0] < 0 else 1]
        affine = np.column_stack([turn * scale, [x, y, z]])
    else:
        affine = np.column_stack([np.diag(pixdim[1:4]), [0, 0, 0]])
    steps = np.prod([max(1, n) for n in dim[4:dim[0] + 1]]) if dim[0] > 3 else 1
    return facts(dim[1:4], FLIP @ affine[:, :3], FLIP @ affine[:, 3], units, steps, True, "RAS in the file")


def vtk(path):
    head = path.read_bytes()[:4096].decode("latin-1")
    take = lambda word: [float(x) for x in re.search(word + r"\s+(\S+)\s+(\S+)\s+(\S+)", head, re.I).groups()]
    spacing = take("SPACING" if "SPACING" in head.upper() else "ASPECT_RATIO")
    return facts(take("DIMENSIONS"), np.diag(spacing), take("ORIGIN"))


def kretz(path, data=None):
    data = path.read_bytes() if data is None else data
    if not data.startswith(b"KRETZFILE 1.0"):
        raise ValueError("no Kretz file")
    at, records = 16, {}
    while at + 8 <= len(data):
        group, element, length = struct.unpack_from("<HHI", data, at)
        records.setdefault((group, element), data[at + 8:at + 8 + length])
        at += 8 + length
    if (0xD000, 1) not in records:
        raise ValueError("no voxels: compressed")
    i, j, k = (struct.unpack("<H", records[(0xC000, n)])[0] for n in (1, 2, 3))
    if len(records[(0xD000, 1)]) < i * j * k:
        raise ValueError("cut off")
    steps = len(records.get((0xD600, 1), b"")) // max(1, i * j * k) or 1
    if (0xC300, 1) not in records and (0x0010, 0x22) in records:
        edge = struct.unpack("<d", records[(0x0010, 0x22)])[0]
        return facts([i, j, k], np.eye(3) * edge, [0, 0, 0], 1, steps, True, "probe")
    return {"samples": [i, j, k], "steps": steps, "frame": "probe"}  # of a fan: voxels are the program's own choice


def toshiba(path):
    """The grid of a RawDataExport, by the text beside it."""
    text = (path.parent / "PatientInfo.txt").read_text(encoding="latin-1")
    samples = [int(re.search(rf"^{word} = (\d+)", text, re.M)[1]) for word in ("Range", "Azimuth", "Elevation")]
    if path.stat().st_size != np.prod(samples):
        raise ValueError("another number of bytes than of samples")
    return {"samples": samples, "frame": "probe"}


def dicom(path):
    import pydicom
    files = [p for p in sorted(path.rglob("*")) if p.is_file()] if path.is_dir() else [path]
    sets = [pydicom.dcmread(p, force=False, stop_before_pixels=True) for p in files]
    first = sets[0]
    if "Rows" not in first:
        whole = pydicom.dcmread(files[0])
        data = bytes(whole[0x7FE1, 0x1101].value) if (0x7FE1, 0x1101) in whole else b""
        if b"KRETZFILE" in data:
            return kretz(path, data[data.index(b"KRETZFILE"):])
    if path.is_file() and "NumberOfFrames" not in first and "ImagePositionPatient" in first:
        sets = [pydicom.dcmread(p, stop_before_pixels=True) for p in sorted(path.parent.glob("*.dcm"))]
        sets = [s for s in sets if s.get("SeriesInstanceUID") == first.get("SeriesInstanceUID")]
    if "ImagePositionPatient" in first and len(sets) > 1:
        x, y = (np.array(first.ImageOrientationPatient[n:n + 3], float) for n in (0, 3))
        normal = np.cross(x, y)
        sets.sort(key=lambda s: float(np.dot(normal, np.array(s.ImagePositionPatient, float))))
        places = np.array([s.ImagePositionPatient for s in sets], float)
        step = (places[-1] - places[0]) / (len(sets) - 1)
        down, across = (float(v) for v in first.PixelSpacing)
        return facts([first.Columns, first.Rows, len(sets)], np.column_stack([x * across, y * down, step]), places[0])
    if (0x3001, 0x1001) in first or str(first.get("SOPClassUID", "")).startswith("1.2.840.113543.6.6"):
        spacing = [float(first[t].value) * 10 for t in ((0x0018, 0x602C), (0x0018, 0x602E), (0x3001, 0x1003))]
        depth = int(first[0x3001, 0x1001].value)
        return facts([first.Columns, first.Rows, depth], np.diag(spacing), [0, 0, 0], 1, first.get("NumberOfFrames", 1))
    raise ValueError(f"{first.get('NumberOfFrames', 1)} frames of {first.get('Columns')} x {first.get('Rows')}: see the file")


# ---- meshes

def surface(points, triangles):
    """Triangles, and the box of the points that they use."""
    used = np.array(points, float)[np.unique(np.array(triangles))]
    if not np.isfinite(used).all():
        raise ValueError("a vertex at no finite place")
    return {"triangles": len(triangles), "size": (used.max(0) - used.min(0)).tolist()}


def stl(path):
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        rows = np.frombuffer(data[84:], dtype=np.dtype([("n", "<3f4"), ("v", "<9f4"), ("a", "<u2")]))
        points = rows["v"].reshape(-1, 3)
    else:
        points = [[float(x) for x in v] for v in re.findall(r"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data.decode("latin-1"), re.I)]
    return surface(points, np.arange(len(points)).reshape(-1, 3))


def ply(path):
    data = path.read_bytes()
    end = re.search(rb"end_header\r?\n", data).end()
    head, elements = data[:end].decode("latin-1").replace("\r", ""), []
    kinds = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4", "double": "f8",
             "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4", "float32": "f4",
             "float64": "f8"}
    for line in head.split("\n"):
        words = line.split()
        if words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append(words[1:])
    text = data[end:].split() if "ascii" in head else None
    order, at = ("<" if "little" in head else ">"), end
    points, triangles = [], []

    def take(kind):
        nonlocal at
        if text is not None:
            return float(text.pop(0))
        value = np.frombuffer(data, order + kinds[kind], 1, at)[0]
        at += np.dtype(kinds[kind]).itemsize
        return value
    if text is not None:
        text.reverse()
        pop, text = text, type("Words", (), {"pop": staticmethod(lambda _: pop.pop())})
    for name, count, properties in elements:
        for _ in range(count):
            row = {}
            for p in properties:
                row[p[-1]] = [take(p[2]) for _ in range(int(take(p[1])))] if p[0] == "list" else take(p[0])
            if name == "vertex":
                points.append([row["x"], row["y"], row["z"]])
            elif name == "face":
                corners = [int(v) for v in row.get("vertex_indices", row.get("vertex_index"))]
                triangles += [[corners[0], corners[n - 1], corners[n]] for n in range(2, len(corners))]
    if not np.isfinite(np.array(points)).all():
        raise ValueError("a vertex at no finite place")
    return surface(points, triangles)


def obj(path):
    points, triangles = [], []
    for line in path.read_text(encoding="latin-1").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(x) for x in words[1:4]])
        elif words[:1] == ["f"]:
            corners = [int(w.split("/")[0]) for w in words[1:]]
            corners = [c - 1 if c > 0 else len(points) + c for c in corners]
            triangles += [[corners[0], corners[n - 1], corners[n]] for n in range(2, len(corners))]
    return surface(points, triangles)


def glb(path):
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    root = json.loads(data[20:20 + length])
    if root.get("extensionsRequired"):
        raise NotImplementedError("this reader knows no " + ", ".join(root["extensionsRequired"]))
    binary = data[28 + length:]
    node = root["nodes"][0]
    primitive = root["meshes"][node["mesh"]]["primitives"][0]

    def values(index, kind, components):
        accessor = root["accessors"][index]
        view = root["bufferViews"][accessor["bufferView"]]
        at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return np.frombuffer(binary, kind, accessor["count"] * components, at).reshape(-1, components)
    points = values(primitive["attributes"]["POSITION"], "<f4", 3) * node.get("scale", [1, 1, 1]) * 1000
    faces = values(primitive["indices"], {5125: "<u4", 5123: "<u2"}[root["accessors"][primitive["indices"]]["componentType"]], 1)
    return surface(np.column_stack([points[:, 0], -points[:, 2], points[:, 1]]), faces.reshape(-1, 3))


def three_mf(path):
    with zipfile.ZipFile(path) as file:
        root = xml.fromstring(file.read(next(n for n in file.namelist() if n.lower().endswith(".model"))))
    core = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    points, triangles = [], []
    for item in root.iter(core + "item"):
        place = np.array((item.get("transform") or "1 0 0 0 1 0 0 0 1 0 0 0").split(), float).reshape(4, 3)
        for thing in root.iter(core + "object"):
            if thing.get("id") == item.get("objectid"):
                base = len(points)
                points += [np.array([float(v.get(a)) for a in "xyz"] + [1]) @ place for v in thing.iter(core + "vertex")]
                triangles += [[base + int(t.get(a)) for a in ("v1", "v2", "v3")] for t in thing.iter(core + "triangle")]
    return surface(np.array(points) * UNITS[root.get("unit", "millimeter")], triangles)


READERS = {".nrrd": nrrd, ".nhdr": nrrd, ".mha": meta, ".mhd": meta, ".nii": nifti, ".gz": nifti, ".vtk": vtk, ".vol": kretz,
           ".bin": toshiba, ".dcm": dicom, ".stl": stl, ".ply": ply, ".obj": obj, ".glb": glb, ".3mf": three_mf}
