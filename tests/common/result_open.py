"""Opens a result file as its users do: with the snippet of docs/result-file.md in h5py, by the rules of
VTKHDF, and through the .xdmf in an XDMF reader if one is installed (VTK's or ParaView's).
Arguments: the result file, the folder of the sources. Exit code 77: h5py is not installed."""
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET

try:
    import h5py
    import numpy as np
except ImportError:
    print("skip: h5py is not installed")
    sys.exit(77)

path, source = sys.argv[1], sys.argv[2]
folder, name = os.path.split(path)
os.chdir(folder)
xdmf = name.replace(".h5", ".xdmf")


def check_snippet():
    text = open(os.path.join(source, "docs/result-file.md"), encoding="utf-8").read()
    snippet = re.search(r"```python\n(.*?)```", text, re.S).group(1)
    assert len(snippet.strip().splitlines()) == 5
    got = {}
    exec(snippet.replace("antuono.h5", name), got)
    assert len(got["t"]) == len(got["E"]) > 0 and np.all(np.diff(got["t"]) >= 0)
    assert len(got["x"]) == len(got["y"]) == len(got["p"]) > 0


def check_units(f):
    def visit(where, o):
        if isinstance(o, h5py.Dataset):
            assert isinstance(o.attrs["units"], str) and o.attrs["units"], where
            assert isinstance(o.attrs["description"], str) and o.attrs["description"], where
    f.visititems(visit)
    assert f.attrs["format"] == "plunge"


def outputs(f):
    """Time, points and fields of each output, by the rules of VTKHDF."""
    v, steps = f["VTKHDF"], f["VTKHDF/Steps"]
    assert v.attrs["Type"] == b"PolyData" and tuple(v.attrs["Version"]) == (2, 0)
    assert steps.attrs["NSteps"] == len(steps["Values"])
    kinds = ["Vertices", "Lines", "Polygons", "Strips"]
    for k, t in enumerate(steps["Values"]):
        part = steps["PartOffsets"][k]
        assert part == k and steps["NumberOfParts"][k] == 1
        a, n = steps["PointOffsets"][k], v["NumberOfPoints"][part]
        for i, kind in enumerate(kinds):
            g, first = v[kind], steps["CellOffsets"][k, i]
            cells, ids = g["NumberOfCells"][part], g["NumberOfConnectivityIds"][part]
            assert first == g["NumberOfCells"][:part].sum()
            # a part has one offset more than it has cells
            offsets = g["Offsets"][first + part:first + part + cells + 1]
            begin = steps["ConnectivityIdOffsets"][k, i]
            numbers = g["Connectivity"][begin:begin + ids]
            assert offsets[0] == 0 and offsets[-1] == ids == len(numbers)
            assert len(numbers) == 0 or np.array_equal(numbers, np.arange(n))
        fields = {}
        for field, data in v["PointData"].items():
            b = steps["PointDataOffsets"][field][k]
            fields[field] = data[b:b + n]
        yield t, v["Points"][a:a + n], fields


def slab(item):
    """The numbers that a HyperSlab of the .xdmf points to."""
    how, what = item.findall("DataItem")
    file, where = what.text.strip().split(":")
    start, stride, count = np.array(how.text.split(), int).reshape(3, -1)
    assert np.all(stride == 1)
    data = h5py.File(file)[where]
    got = data[tuple(slice(s, s + c) for s, c in zip(start, count))]
    assert list(got.shape) == [int(d) for d in item.get("Dimensions").split()]
    return got


def check_xdmf_text(expected):
    steps = ET.parse(xdmf).getroot().findall("Domain/Grid/Grid")
    assert len(steps) == len(expected)
    for step, (t, points, fields) in zip(steps, expected):
        assert float(step.find("Time").get("Value")) == t
        assert np.array_equal(slab(step.find("Geometry/DataItem")), points)
        got = {a.get("Name"): slab(a.find("DataItem")) for a in step.findall("Attribute")}
        assert got.keys() == fields.keys()
        assert all(np.array_equal(got[k], fields[k]) for k in got)


READ_WITH_VTK = """
import sys
from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as P
r = vtkXdmfReader()
r.SetFileName(sys.argv[1])
r.UpdateInformation()
for t in r.GetOutputInformation(0).Get(P.TIME_STEPS()):
    r.UpdateTimeStep(t)
    o = r.GetOutputDataObject(0)
    d = o.GetPointData()
    print(repr(t), o.GetNumberOfPoints(), o.GetNumberOfCells(),
          *map(repr, o.GetPoint(o.GetNumberOfPoints() - 1)), repr(d.GetArray("pressure").GetRange()[1]))
"""


def check_with_vtk(expected, line):
    script = "read_with_vtk.py"
    with open(script, "w", encoding="utf-8") as f:
        f.write(READ_WITH_VTK)
    for python in filter(None, (sys.executable, shutil.which("pvpython"))):
        run = subprocess.run([python, script, xdmf], capture_output=True, text=True, check=False)
        if "No module named" in run.stderr:
            continue
        rows = [r.split() for r in run.stdout.splitlines()]
        assert len(rows) == len(expected), run.stderr
        for row, (t, points, fields) in zip(rows, expected):
            assert float(row[0]) == t
            assert int(row[1]) == len(points) and int(row[2]) == (1 if line else len(points))
            assert np.allclose([float(v) for v in row[3:6]], points[-1], rtol=1e-15)
            assert np.isclose(float(row[6]), fields["pressure"].max(), rtol=1e-15)
        return f"read by vtkXdmfReader of {python}"
    return "vtkXdmfReader is not installed (Debian's python3-vtk9 has none, its ParaView does)"


with h5py.File(path) as file:
    check_units(file)
    everything = list(outputs(file))
    is_line = file["VTKHDF/Lines/NumberOfCells"][0] == 1
check_snippet()
assert len(everything) > 2
check_xdmf_text(everything)
print(check_with_vtk(everything, is_line))
