"""A tetrahedron in every format of meshes, for make_corpus.py."""
import base64
import io
import json
import struct
import zipfile
import zlib

CORNERS = [(0, 0, 0), (10, 0, 0), (0, 10, 0), (0, 0, 10)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def ply(order):
    form = {"": "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}[order]
    head = (f"ply\nformat {form} 1.0\ncomment SPACE=LPS\nelement vertex 4\n"
            + "".join(f"property float {p}\n" for p in "x y z nx ny nz visibility s t measured".split())
            + "property uchar label\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n").encode()
    rows = [c + (0, 0, 1, 0.5, 0.25, 0.75, 1, 3) for c in CORNERS]
    if not order:
        lines = [" ".join(map(str, r)) for r in rows] + ["3 %d %d %d" % f for f in FACES]
        return head + "\n".join(lines).encode() + b"\n"
    return (head + b"".join(struct.pack(order + "10fB", *r) for r in rows)
            + b"".join(struct.pack(order + "B3i", 3, *f) for f in FACES))


def stl_binary():
    body = b"".join(struct.pack("<12fH", 0, 0, 1, *sum((CORNERS[v] for v in f), ()), 0) for f in FACES)
    return b"COLOR=".ljust(80, b" ") + struct.pack("<I", len(FACES)) + body


def stl_text():
    text = "solid a\n"
    for f in FACES:
        corners = "".join("vertex %g %g %g\n" % CORNERS[v] for v in f)
        text += f"facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n"
    return (text + "endsolid a\n").encode()


def obj():
    text = "# SPACE=RAS\n" + "".join("v %g %g %g\nvt 0.5 0.5\n" % c for c in CORNERS)
    return (text + "".join("f %d/%d %d/%d %d/%d\n" % tuple(v + 1 for v in f for _ in "pt") for f in FACES)).encode()


def counted(form, rows):
    return struct.pack("<Q", len(rows)) + b"".join(struct.pack("<" + form, *r) for r in rows)


def mesh_answer():
    """As core/io/reader_wire.cpp has it: positions, normals, visibility, triangles, corners, measured, labels."""
    return (counted("3f", CORNERS) + counted("3f", [(0, 0, 1)] * 4) + counted("f", [(0.5,)] * 4)
            + counted("3I", FACES) + counted("6f", [(0, 0, 1, 0, 0, 1)] * 4) + counted("f", [(1,)] * 4)
            + counted("B", [(3,)] * 4))


def glb(packed=False):
    """Integers with a scale, normals, an index list, and a sparse change; or text with its buffer in it."""
    points = b"".join(struct.pack("<4h", *c, 0) for c in CORNERS)
    normals = struct.pack("<12f", *[0, 0, 1] * 4)
    faces = b"".join(struct.pack("<3H", *f) for f in FACES)
    sparse = struct.pack("<BxxxhhhH", 3, 0, 0, 10, 0)
    data = points + normals + faces + sparse
    views, at = [], 0
    for part, stride in ((points, 8), (normals, 0), (faces, 0), (sparse, 0)):
        views.append({"buffer": 0, "byteOffset": at, "byteLength": len(part)} | ({"byteStride": stride} if stride else {}))
        at += len(part)
    change = {"count": 1, "indices": {"bufferView": 3, "componentType": 5121},
              "values": {"bufferView": 3, "byteOffset": 4}}
    root = {"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_mesh_quantization"], "scene": 0,
            "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "children": [1], "scale": [0.001, 0.001, 0.001]},
                                                  {"translation": [1, 0, 0], "rotation": [0, 0, 0, 1]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2}]}],
            "buffers": [{"byteLength": len(data)}], "bufferViews": views,
            "accessors": [{"bufferView": 0, "componentType": 5122, "type": "VEC3", "count": 4, "sparse": change},
                          {"bufferView": 1, "componentType": 5126, "type": "VEC3", "count": 4},
                          {"bufferView": 2, "componentType": 5123, "type": "SCALAR", "count": 12}]}
    if packed:
        root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
        return json.dumps(root).encode()
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    return (b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(data)) + struct.pack("<I", len(text)) + b"JSON" + text
            + struct.pack("<I", len(data)) + b"BIN\0" + data)


def three_mf(unit="inch", extra=""):
    points = "".join('<vertex x="%g" y="%g" z="%g"/>' % c for c in CORNERS)
    faces = "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % f for f in FACES)
    core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
    return (f'<?xml version="1.0"?><model unit="{unit}" xmlns="{core}"><resources><object id="1" type="model"><mesh>'
            f'<vertices>{points}</vertices><triangles>{faces}</triangles></mesh></object><object id="2"><components>'
            f'<component objectid="1" transform="0 1 0 -1 0 0 0 0 1 0 5 0"/></components></object></resources>'
            f'<build><item objectid="2"/>{extra}</build></model>').encode()


def zipped(model):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as file:
        file.writestr(zipfile.ZipInfo("3D/3dmodel.model"), model)
    return buffer.getvalue()


def vtp(packed):
    def array(kind, name, values, count=1):
        head = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{count}" '
        data = struct.pack("<%d%s" % (len(values), {"Float32": "f", "Int32": "i"}[kind]), *values)
        if not packed:
            return head + 'format="ascii">' + " ".join(map(str, values)) + "</DataArray>"
        block = zlib.compress(data)
        facts = struct.pack("<4I", 1, len(data), 0, len(block))
        return head + 'format="binary">' + (base64.b64encode(facts) + base64.b64encode(block)).decode() + "</DataArray>"

    flat = [x for c in CORNERS for x in c]
    corners = [v for f in FACES for v in f]
    return (f'<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"'
            f'{" compressor=" + chr(34) + "vtkZLibDataCompressor" + chr(34) if packed else ""}><PolyData><FieldData><Array '
            f'type="String" Name="SPACE" format="ascii">82 65 83 0</Array></FieldData><Piece NumberOfPoints="4" '
            f'NumberOfPolys="4"><PointData Normals="n">{array("Float32", "n", [0, 0, 1] * 4, 3)}</PointData><Points>'
            f'{array("Float32", "p", flat, 3)}</Points><Polys>{array("Int32", "connectivity", corners)}'
            f'{array("Int32", "offsets", [3, 6, 9, 12])}</Polys></Piece></PolyData></VTKFile>').encode()


def vtk_surface(binary):
    flat = [x for c in CORNERS for x in c]
    cells = [v for f in FACES for v in (3, *f)]
    numbers = lambda form, values: (struct.pack(">%d%s" % (len(values), form), *values) if binary
                                    else " ".join(map(str, values)).encode()) + b"\n"
    return (b"# vtk DataFile Version 3.0\nSPACE=RAS\n" + (b"BINARY" if binary else b"ASCII")
            + b"\nDATASET POLYDATA\nPOINTS 4 float\n" + numbers("f", flat) + b"POLYGONS 4 16\n" + numbers("i", cells)
            + b"POINT_DATA 4\n")
