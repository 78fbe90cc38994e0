#!/usr/bin/env python3
"""raycast_vtk.py BENCHMARKS: our ray-caster against VTK's vtkOpenGLGPUVolumeRayCastMapper, both lit and translucent in the same
software OpenGL: the same volume of bytes, camera, step and transfer function. Prints how long a picture takes, and how far the
pictures are apart where VTK is given our lights.

By hand, on a quiet machine: apt-get install python3-vtk9 xvfb; then
LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a python3 tests/benchmarks/raycast_vtk.py build/release/sonoskin_benchmarks
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

try:
    import numpy
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    print("VTK for Python is not installed (python3-vtk9): nothing is compared.")
    sys.exit(0)

PICTURES = 12
DIMMED = 0.5  # lit colours of VTK's picture end at 1

# shaders/volume/translucent.frag, without shadows, in VTK's words.
LIGHTING = """
vec4 computeLighting(vec4 color, int component, float label)
{
  vec3 cell = in_cellStep[0], low, high;
  for (int axis = 0; axis < 3; ++axis) {
    vec3 aside = vec3(0.0);
    aside[axis] = cell[axis];
    high[axis] = texture3D(in_volume[0], g_dataPos + aside).r;
    low[axis] = texture3D(in_volume[0], g_dataPos - aside).r;
  }
  vec3 gradient = clamp(vec3(%(scale)s) * (high - low), -1.0, 1.0);
  float strength = length(gradient);
  vec3 normal = -gradient / max(strength, 1e-4);
  float surfaceness = clamp(6.0 * strength, 0.0, 1.0);
  float key = mix(0.55, max(0.25 + 0.85 * dot(normal, vec3(%(keyAxes)s)), 0.0), surfaceness);
  float fill = mix(0.5, max(0.3 + 0.7 * dot(normal, vec3(%(fillAxes)s)), 0.0), surfaceness);
  vec3 light = vec3(%(keyColour)s) * key + vec3(%(fillColour)s) * fill + vec3(%(ambient)s);
  return vec4(%(dimmed)s * color.rgb * light, color.a);
}
"""


def words(vector):
    return ", ".join(f"{float(x):.7g}" for x in vector)


def run_ours(program, folder):
    """Milliseconds of wall and processor per picture."""
    command = [program, "--benchmark_filter=raycast/shadowless", "--benchmark_format=json", "--benchmark_min_time=2"]
    out = subprocess.run(command, env={**os.environ, "SONOSKIN_RACE": str(folder)}, capture_output=True, text=True, check=True)
    row = json.loads(out.stdout)["benchmarks"][0]
    return row["real_time"], row["cpu_time"]


def read_volume(folder, race):
    data = vtk.vtkImageData()
    data.SetDimensions(*race["dims"])
    data.SetSpacing(*race["spacing"])
    data.SetOrigin(*race["origin"])
    data.SetDirectionMatrix(*numpy.array(race["direction"]).T.ravel())
    data.GetPointData().SetScalars(numpy_to_vtk(numpy.fromfile(folder / "scan.u8", numpy.uint8), deep=1))
    return data


def make_volume(data, race):
    colour, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    for value, (r, g, b, a) in enumerate(race["transfer"]):
        colour.AddRGBPoint(value, r, g, b)
        opacity.AddPoint(value, a)
    mapper = vtk.vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputData(data)
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(race["step"])
    mapper.UseJitteringOn()
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    look = volume.GetProperty()
    look.SetColor(colour)
    look.SetScalarOpacity(opacity)
    look.SetScalarOpacityUnitDistance(race["step"])
    look.SetInterpolationTypeToLinear()
    look.ShadeOn()
    return volume


def make_window(volume, race):
    renderer = vtk.vtkRenderer()
    renderer.AddVolume(volume)
    renderer.SetBackground(0, 0, 0)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*race["eye"])
    camera.SetFocalPoint(*race["target"])
    camera.SetViewUp(*race["up"])
    camera.SetViewAngle(race["angle"])
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*race["size"])
    window.AddRenderer(renderer)
    return window, renderer, camera


def time_vtk(volume, race):
    window, renderer, camera = make_window(volume, race)
    window.Render()
    window.WaitForCompletion()
    start, cpu = time.perf_counter(), time.process_time()
    for _ in range(PICTURES):
        camera.Azimuth(1.7)
        renderer.ResetCameraClippingRange()
        window.Render()
        window.WaitForCompletion()
    driver = window.ReportCapabilities().split("OpenGL renderer string:")[-1].splitlines()[0].strip()
    return 1e3 * (time.perf_counter() - start) / PICTURES, 1e3 * (time.process_time() - cpu) / PICTURES, driver


def picture_with_our_lights(volume, data, race):
    spacing = numpy.array(data.GetSpacing())
    direction = data.GetDirectionMatrix()
    axes = numpy.array([[direction.GetElement(r, c) for c in range(3)] for r in range(3)])
    lights = {"scale": words(2 * spacing.min() / spacing), "keyAxes": words(axes.T @ numpy.array(race["key"][0])),
              "fillAxes": words(axes.T @ numpy.array(race["fill"][0])), "keyColour": words(race["key"][1]),
              "fillColour": words(race["fill"][1]), "ambient": words(race["ambient"]), "dimmed": DIMMED}
    volume.GetShaderProperty().AddFragmentShaderReplacement("//VTK::ComputeLighting::Dec", True, LIGHTING % lights, False)
    window, _, _ = make_window(volume, race)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    width, height = race["size"]
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[..., :3] / 255


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        ours = run_ours(sys.argv[1], folder)
        race = json.loads((folder / "race.json").read_text())
        data = read_volume(folder, race)
        wall, cpu, driver = time_vtk(make_volume(data, race), race)
        print(f"VTK {vtk.vtkVersion().GetVTKVersion()}, {driver}: {wall:.0f} ms wall, {cpu:.0f} ms CPU a picture")
        print(f"ours: {ours[0]:.0f} ms wall, {ours[1]:.0f} ms CPU; {wall / ours[0]:.1f} times as fast, {cpu / ours[1]:.1f} in CPU")
        width, height = race["size"]
        mine = DIMMED * numpy.fromfile(folder / "ours.f32", numpy.float32).reshape(height, width, 4)[..., :3]
        theirs = picture_with_our_lights(make_volume(data, race), data, race)
        apart, seen = numpy.abs(mine - theirs), (mine.max(2) > 0) | (theirs.max(2) > 0)
        print(f"apart, with the same lights: {100 * apart.mean():.2f} % of full scale, {100 * apart[seen].mean():.2f} % where "
              f"anything is seen ({100 * seen.mean():.0f} % of the picture)")


main()
