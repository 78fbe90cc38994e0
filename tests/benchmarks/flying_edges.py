#!/usr/bin/env python3
"""flying_edges.py: CPU milliseconds that VTK's vtkFlyingEdges3D takes for the sphere of iso_surface_benchmark.cpp.

By hand: apt-get install python3-vtk9; then run it beside
build/release/sonoskin_benchmarks --benchmark_filter='Surface/0'
The grid is full: every node of the box is there before the clock starts; the benchmark evaluates its own.
"""
import time

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

CELLS, MARGIN = 400, 6
nodes = CELLS + 2 * MARGIN + 1
x = numpy.linspace(-1 - 2 * MARGIN / CELLS, 1 + 2 * MARGIN / CELLS, nodes, dtype=numpy.float32)
field = numpy.sqrt(x[None, None, :] ** 2 + x[None, :, None] ** 2 + x[:, None, None] ** 2) - numpy.float32(1)

image = vtk.vtkImageData()
image.SetDimensions(nodes, nodes, nodes)
image.GetPointData().SetScalars(numpy_to_vtk(field.ravel(), deep=0))
for normals in (False, True):
    best = float("inf")
    for _ in range(7):
        extract = vtk.vtkFlyingEdges3D()
        extract.SetInputData(image)
        extract.SetValue(0, 0)
        extract.SetComputeScalars(False)
        extract.SetComputeGradients(False)
        extract.SetComputeNormals(normals)
        start = time.process_time()
        extract.Update()
        best = min(best, time.process_time() - start)
    print(f"{field.size / 1e6:.1f} million nodes, {extract.GetOutput().GetNumberOfPolys()} triangles, "
          f"{'with' if normals else 'without'} normals: {1e3 * best:.0f} ms")
