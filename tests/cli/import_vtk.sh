#!/usr/bin/env bash
# Files of VTK become results: the same sloping surface, a linear scalar on grids of every kind, written by VTK's own
# writers in Python, lies where it should to rounding; series of files have their times; OpenFOAM's cases are read.
source "$2/tests/cli/begin"
[ -e "$(dirname "$program")/libplunge-vtk.so" ] || { echo "skipped: built without the VTK library"; exit 77; }
/usr/bin/python3 -c 'import vtkmodules.vtkIOXML, h5py, numpy' 2>/dev/null || { echo "skipped: no python3-vtk9, h5py or numpy"; exit 77; }

cat >write.py <<'E2'
import os, json
import numpy as np, h5py
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, vtkPolyData, vtkCellArray, vtkMultiBlockDataSet
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkFiltersExtraction import vtkExtractCells
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOXML import (vtkXMLImageDataWriter, vtkXMLRectilinearGridWriter, vtkXMLStructuredGridWriter,
                                 vtkXMLUnstructuredGridWriter, vtkXMLPolyDataWriter, vtkXMLMultiBlockDataWriter)
from vtkmodules.vtkIOLegacy import vtkDataSetWriter

NX, NY = 21, 16  # [0, 4] x [0, 3], the surface y = 2 + 0.1 x + 0.2 t
def level(x, y, t): return 0.5 + 0.3 * (2 + 0.1 * x + 0.2 * t - y)
def add(data, values, name="alpha"):
    a = numpy_to_vtk(np.ascontiguousarray(values), deep=True); a.SetName(name); data.AddArray(a)
def image(t, nz=1):
    g = vtkImageData(); g.SetDimensions(NX, NY, nz); g.SetSpacing(4 / (NX - 1), 3 / (NY - 1), 0.1)
    p = np.array([g.GetPoint(i) for i in range(g.GetNumberOfPoints())])
    add(g.GetPointData(), level(p[:, 0], p[:, 1], t)); return g, p
def save(writer, data, name, ascii=False):
    writer.SetInputData(data); writer.SetFileName(name)
    if ascii: writer.SetDataModeToAscii() if hasattr(writer, "SetDataModeToAscii") else writer.SetFileTypeToASCII()
    elif not hasattr(writer, "SetDataModeToAscii"): writer.SetFileTypeToBinary()
    assert writer.Write() == 1, name
for k, t in enumerate([0.0, 0.5]):
    g, p = image(t)
    save(vtkXMLImageDataWriter(), g, f"a{k}.vti")
    save(vtkDataSetWriter(), g, f"a{k}.vtk")
    save(vtkDataSetWriter(), g, f"ascii{k}.vtk", True)
    r = vtkRectilinearGrid(); r.SetDimensions(NX, NY, 1)
    r.SetXCoordinates(numpy_to_vtk(np.linspace(0, 4, NX), deep=True)); r.SetYCoordinates(numpy_to_vtk(np.linspace(0, 3, NY), deep=True))
    r.SetZCoordinates(numpy_to_vtk(np.zeros(1), deep=True)); r.GetPointData().ShallowCopy(g.GetPointData())
    save(vtkXMLRectilinearGridWriter(), r, f"a{k}.vtr", True)
    # a block in three dimensions whose z is up, skewed along x, with the field of its points
    s = vtkStructuredGrid(); s.SetDimensions(NX, 3, NY); pts = vtkPoints(); pts.SetDataTypeToDouble()
    q = np.array([(x, y, z) for z in np.linspace(0, 3, NY) for y in (0, 0.1, 0.2) for x in np.linspace(0, 4, NX)])
    pts.SetData(numpy_to_vtk(q, deep=True)); s.SetPoints(pts); add(s.GetPointData(), level(q[:, 0], q[:, 2], t)); save(vtkXMLStructuredGridWriter(), s, f"a{k}.vts")
    append = vtkAppendFilter(); append.AddInputData(s); append.Update(); u = append.GetOutput()
    add(u.GetFieldData(), np.array([1000 * t]), "when"); save(vtkXMLUnstructuredGridWriter(), u, f"a{k}.vtu")
    if k == 0:  # the block and the flat image in two parts each, as blocks and as a parallel file
        for whole, name in ((u, "block"), (g, "flat")):
            parts = []
            for side in (0, 1):
                e, ids = vtkExtractCells(), vtkIdList()
                for c in range(whole.GetNumberOfCells()):
                    box = whole.GetCell(c).GetBounds()
                    if (box[0] + box[1] > 4) == bool(side): ids.InsertNextId(c)
                e.SetInputData(whole); e.SetCellList(ids); e.Update(); parts.append(e.GetOutput())
                save(vtkXMLUnstructuredGridWriter(), parts[-1], f"{name}{side}.vtu")
            blocks = vtkMultiBlockDataSet()
            for side in (0, 1): blocks.SetBlock(side, parts[side])
            save(vtkXMLMultiBlockDataWriter(), blocks, f"{name}.vtm")
            open(f"{name}.pvtu", "w").write('<VTKFile type="PUnstructuredGrid" version="0.1" byte_order="LittleEndian" header_type="UInt32">'
                '<PUnstructuredGrid GhostLevel="0"><PPointData><PDataArray type="Float64" Name="alpha"/></PPointData><PPoints>'
                f'<PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints><Piece Source="{name}0.vtu"/><Piece Source="{name}1.vtu"/>'
                "</PUnstructuredGrid></VTKFile>")
    # particles
    i, j = np.meshgrid(np.arange(40), np.arange(20 - 2 * k), indexing="ij")
    xyz = np.stack([0.05 + 0.1 * i.ravel(), 0 * i.ravel(), 0.05 + 0.1 * j.ravel()], axis=1)
    d = vtkPolyData(); pts = vtkPoints(); pts.SetDataTypeToDouble(); pts.SetData(numpy_to_vtk(xyz, deep=True)); d.SetPoints(pts)
    verts = vtkCellArray()
    for n in range(len(xyz)): verts.InsertNextCell(1); verts.InsertCellPoint(n)
    d.SetVerts(verts); add(d.GetPointData(), 0.1 * xyz + t, "Vel"); add(d.GetPointData(), 1000 + 0 * xyz[:, 0], "Rhop")
    save(vtkXMLPolyDataWriter(), d, f"cloud{k}.vtp"); save(vtkDataSetWriter(), d, f"cloud{k}.vtk")
    with open(f"cloud{k}.csv", "w") as f:
        f.write("x,y,u,v,rho\n")
        for a, b in zip(xyz, 0.1 * xyz + t): f.write(f"{a[0]:.17g},{a[2]:.17g},{b[0]:.17g},{b[2]:.17g},1000\n")
    with h5py.File(f"a{k}.vtkhdf", "w") as f:  # by the specification: ImageData, version 1.0, three planes (9.1 crashes on one)
        h = f.create_group("VTKHDF"); h.attrs["Version"] = (1, 0); h.attrs["Type"] = np.bytes_("ImageData")
        h.attrs["WholeExtent"] = (0, NX - 1, 0, NY - 1, 0, 2); h.attrs["Origin"] = (0., 0., 0.)
        h.attrs["Spacing"] = (4 / (NX - 1), 3 / (NY - 1), 1.); h.attrs["Direction"] = (1., 0., 0., 0., 1., 0., 0., 0., 1.)
        h["PointData/alpha"] = np.repeat(level(p[:, 0], p[:, 1], t).reshape(1, NY, NX), 3, axis=0)
open("all.pvd", "w").write('<?xml version="1.0"?><VTKFile type="Collection"><Collection>' +
    "".join(f'<DataSet timestep="{500*k}" part="0" file="a{k}.vti"/>' for k in (0, 1)) + "</Collection></VTKFile>")
json.dump({"file-series-version": "1.0", "files": [{"name": f"a{k}.vtk", "time": 500 * k} for k in (0, 1)]}, open("all.vtk.series", "w"))
open("up.pvd", "w").write('<VTKFile><Collection><DataSet timestep="0" file="../../etc/passwd"/></Collection></VTKFile>')
# a drop and a cavity: discs above and below a flat surface
g, p = image(0); x, y = p[:, 0], p[:, 1]
discs = np.where(y > 1.4, 0.3 - np.hypot(x - 2, y - 2.2), np.minimum(1.4 - y + 1e-9, np.hypot(x - 2, y - 0.7) - 0.3))
g.GetPointData().RemoveArray("alpha"); add(g.GetPointData(), discs, "phi"); save(vtkXMLImageDataWriter(), g, "discs.vti")

# an OpenFOAM case, one cell thick: 8 x 6 cells, water up to y = 1.5, then to 2
def foam(name, cls, body, where):
    os.makedirs(os.path.dirname(where), exist_ok=True)
    open(where, "w").write(f'FoamFile {{ version 2.0; format ascii; class {cls}; object {name}; }}\n{body}\n')
nx, ny = 8, 6
pt = lambda i, j, k: k * (nx + 1) * (ny + 1) + j * (nx + 1) + i
cell = lambda i, j: j * nx + i
pts = [(4 * i / nx, 3 * j / ny, 0.1 * k) for k in (0, 1) for j in range(ny + 1) for i in range(nx + 1)]
inner, outer = [], {"walls": [], "frontAndBack": []}
for j in range(ny):
    for i in range(nx):
        if i + 1 < nx: inner.append(((pt(i+1,j,0), pt(i+1,j+1,0), pt(i+1,j+1,1), pt(i+1,j,1)), cell(i, j), cell(i+1, j)))
        if j + 1 < ny: inner.append(((pt(i,j+1,0), pt(i,j+1,1), pt(i+1,j+1,1), pt(i+1,j+1,0)), cell(i, j), cell(i, j+1)))
        if i == 0: outer["walls"].append(((pt(0,j,0), pt(0,j,1), pt(0,j+1,1), pt(0,j+1,0)), cell(i, j)))
        if i == nx - 1: outer["walls"].append(((pt(nx,j,0), pt(nx,j+1,0), pt(nx,j+1,1), pt(nx,j,1)), cell(i, j)))
        if j == 0: outer["walls"].append(((pt(i,0,0), pt(i+1,0,0), pt(i+1,0,1), pt(i,0,1)), cell(i, j)))
        if j == ny - 1: outer["walls"].append(((pt(i,ny,0), pt(i,ny,1), pt(i+1,ny,1), pt(i+1,ny,0)), cell(i, j)))
        outer["frontAndBack"].append(((pt(i,j,0), pt(i,j+1,0), pt(i+1,j+1,0), pt(i+1,j,0)), cell(i, j)))
        outer["frontAndBack"].append(((pt(i,j,1), pt(i+1,j,1), pt(i+1,j+1,1), pt(i,j+1,1)), cell(i, j)))
inner.sort(key=lambda f: (f[1], f[2]))
faces = [f[0] for f in inner] + [f[0] for n in outer for f in outer[n]]
owner = [f[1] for f in inner] + [f[1] for n in outer for f in outer[n]]
listed = lambda rows: f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)"
mesh = "foam/constant/polyMesh/"
foam("points", "vectorField", listed([f"({a} {b} {c})" for a, b, c in pts]), mesh + "points")
foam("faces", "faceList", listed([f"4({' '.join(map(str, f))})" for f in faces]), mesh + "faces")
foam("owner", "labelList", listed(list(map(str, owner))), mesh + "owner")
foam("neighbour", "labelList", listed([str(f[2]) for f in inner]), mesh + "neighbour")
at, patches = len(inner), ""
for n in outer:
    patches += f"{n} {{ type {'empty' if n == 'frontAndBack' else 'wall'}; nFaces {len(outer[n])}; startFace {at}; }}\n"; at += len(outer[n])
foam("boundary", "polyBoundaryMesh", f"{len(outer)}\n(\n{patches})", mesh + "boundary")
foam("controlDict", "dictionary", "startTime 0; endTime 0.5; deltaT 0.5; writeInterval 1; writeControl timeStep; application interFoam; startFrom startTime; stopAt endTime;", "foam/system/controlDict")
for t, rows in (("0", 3), ("0.5", 4)):
    values = [str(1 if j < rows else 0) for j in range(ny) for i in range(nx)]
    foam("alpha.water", "volScalarField", f"dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<scalar> {listed(values)};\n"
         "boundaryField { walls { type zeroGradient; } frontAndBack { type empty; } }", f"foam/{t}/alpha.water")
open("foam/case.foam", "w")
E2
/usr/bin/python3 write.py >log 2>&1 || fail "no files: $(cat log)"

common='run: same
solver: another
source: made up
scales: {H: 2, g: 9.81, density: 1000}
tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}
spacing: 0.1
units: {length: m, time: ms, velocity: m/s, density: kg/m^3}'
grid() { # name, up, lines of files, field
  printf '%s\ngrid:\n  format: vtk\n  up: %s\n%s\n  columns: {field: "%s"}\n' "$common" "$2" "$3" "$4" >"$1.yaml"
}
both() { printf '  files: [{file: %s, time: 0}, {file: %s, time: 0.5}]' "${1/K/0}" "${1/K/1}"; }
grid vti y "$(both aK.vti)" alpha
grid vtk y "$(both aK.vtk)" alpha
grid ascii y "$(both asciiK.vtk)" alpha
grid vtr y "$(both aK.vtr)" alpha
grid vtkhdf y "$(both aK.vtkhdf)" alpha
grid vts z "$(both aK.vts)" alpha
grid vtu z "$(printf '  time_after: when\n  files: [{file: a0.vtu}, {file: a1.vtu}]')" alpha
for part in block flat; do
  [ $part = block ] && up=z || up=y
  for kind in vtm pvtu; do grid $part-$kind $up "  files: [{file: $part.$kind, time: 0}]" alpha; done
done
grid pvd y "  file: all.pvd" alpha
grid series y "  file: all.vtk.series" alpha
grid slice z "$(printf '  slice: 0.05\n'; both aK.vts)" alpha
grid discs y "  files: [{file: discs.vti, time: 0}]
  level: 0" phi
grid below y "  files: [{file: discs.vti, time: 0}]
  level: 0
  water: below" phi
grid foam y "  file: foam/case.foam" alpha.water
sed -i 's/time: ms/time: s/' foam.yaml

for which in vti vtk ascii vtr vtkhdf vts vtu pvd series slice discs below foam block-vtm block-pvtu flat-vtm flat-pvtu; do
  "$program" import $which.yaml -o $which.h5 >log 2>&1 || fail "$which: $(cat log)"
done
cat >check.py <<'E2'
import h5py, numpy as np
def pieces(name, k):
    s = h5py.File(name + ".h5")["surface"]
    a, b = s["first_piece"][k:k + 2]
    f, p, c = s["first_point"][:], s["points"][:], s["closed"][:]
    return [(p[f[j]:f[j + 1]], c[j]) for j in range(a, b)]
area = lambda q: sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(q, list(q[1:]) + [q[0]])) / 2
for name in "vti vtk ascii vtr vtkhdf vts vtu pvd series slice".split():
    assert list(h5py.File(name + ".h5")["surface/time"][:]) == [0, 0.5], name
    for k, t in enumerate((0, 0.5)):
        (q, closed), = pieces(name, k)
        assert not closed and len(q) >= 21, (name, len(q))
        assert q[0][0] == 0 and q[-1][0] == 4 and all(np.diff(q[:, 0]) >= 0), name  # water on the right
        assert abs(q[:, 1] - (2 + 0.1 * q[:, 0] + 0.2 * t)).max() < 1e-6, (name, k)  # coordinates may be floats
for name in ("block-vtm", "block-pvtu", "flat-vtm", "flat-pvtu"):
    (q, closed), = pieces(name, 0)  # one piece across the parts
    assert not closed and q[0][0] == 0 and q[-1][0] == 4, name
    assert abs(q[:, 1] - (2 + 0.1 * q[:, 0])).max() < 1e-6, name
got = pieces("discs", 0)
assert [c for _, c in got] == [0, 1, 1]
drop = [q for q, c in got if c and q[0][1] > 1.4][0]
hole = [q for q, c in got if c and q[0][1] < 1.4][0]
assert area(drop) < -0.2 and area(hole) > 0.2, (area(drop), area(hole))  # discs of 0.28
inside_out = pieces("below", 0)
assert area([q for q, c in inside_out if c and q[0][1] > 1.4][0]) > 0.2
for k, y in enumerate((1.5, 2)):
    (q, closed), = pieces("foam", k)
    assert not closed and q[0][0] == 0 and q[-1][0] == 4 and abs(q[:, 1] - y).max() < 1e-6, q
assert list(h5py.File("foam.h5")["surface/time"][:]) == [0, 0.5]
E2
/usr/bin/python3 check.py >log 2>&1 || fail "$(tail -3 log)"

# particles are those of a text file
cloud() { printf '%s\nparticles:\n  format: %s\n  files: [{file: cloud0.%s, time: 0}, {file: cloud1.%s, time: 0.5}]\n  columns: {%s}\n' "$common" "$2" "$3" "$3" "$4" >"$1.yaml"; }
of_vtk='x: "Points:0", y: "Points:2", u: "Vel:0", v: "Vel:2", density: Rhop'
cloud text csv csv 'x: x, y: y, u: u, v: v, density: rho'
cloud vtp vtk vtp "$of_vtk"
cloud legacy vtk vtk "$of_vtk"
for which in text vtp legacy; do
  "$program" import $which.yaml -o $which.h5 >log 2>&1 || fail "$which: $(cat log)"
  "$program" diff text.h5 $which.h5 >log 2>&1 || fail "$which is not the same as text: $(cat log)"
done

import_refused vti 's/: "alpha"/: beta/' "11: grid.files[0]: a0.vti has no array 'beta'; it has alpha"
import_refused vts 's/up: z/up: y/' "11: grid.files[0]: a0.vts: the field goes from 0.65 to 0.77 there, so it has no contour at 0.5; correct the field, the level or the axes"
import_refused slice 's/slice: 0.05/slice: 0.7/' "12: grid.files[0]: a0.vts goes from 0 to 0.2 across the tank; slice is at 0.7"
import_refused vtp 's/Vel:2/Vel:5/' "10: particles.files[0]: cloud0.vtp has no component 5 of 'Vel', which has 3, from 0"
import_refused vtp 's/"Vel:2"/Vel/' "10: particles.files[0]: cloud0.vtp has 3 components of 'Vel'; ask for one, as 'Vel:0'"
import_refused vtp 's/Points:2/Points/' "10: particles.files[0]: cloud0.vtp has 3 components of 'Points'; ask for one, as 'Points:0'"
# a flat grid has one place across
sed 's/^  up: y/&\n  slice: 0/' vti.yaml >at.yaml
"$program" import at.yaml -o at.h5 >log 2>&1 && "$program" diff vti.h5 at.h5 >log 2>&1 || fail "a slice where a flat grid is: $(cat log)"
import_refused at 's/slice: 0/slice: 0.3/' "12: grid.files[0]: a0.vti is flat, at 0 across the tank; slice is at 0.3"
# legacy files that end early, in text and in binary, points and fields
for cut in a1.vtk:vtk:11:grid:90 ascii1.vtk:ascii:11:grid:50 cloud1.vtk:legacy:10:particles:20; do
  IFS=: read -r file sidecar line section percent <<<"$cut"
  head -c $(($(stat -c %s $file) * percent / 100)) $file >cut.vtk
  import_refused $sidecar "s/$file/cut.vtk/" "$line: $section.files[1]: cut.vtk is damaged or cut short"
done
import_refused pvd 's/all.pvd/up.pvd/' "9: grid.file: up.pvd names the file '../../etc/passwd', which is not in its folder; name that file in the sidecar"
import_refused vti 's/a0.vti/cloud0.csv/' "11: grid.files[0]: cloud0.csv is no file of VTK: allowed are"
import_refused vti 's/a0.vti/none.vti/' "11: grid.files[0]: cannot read none.vti: No such file or directory"
head -c 900 a1.vti >cut.vti
import_refused vti 's/a1.vti/cut.vti/' "11: grid.files[1]: cut.vti "
import_refused foam 's|foam/case.foam|none/case.foam|' "9: grid.file: cannot read none/case.foam"

# ---- installed elsewhere, the program has its module from there ----
cmake --install "$(dirname "$program")" --prefix "$folder/stage" >log 2>&1 || fail "no installation: $(cat log)"
stage/bin/plunge import vti.yaml -o staged.h5 >log 2>&1 && "$program" diff vti.h5 staged.h5 >log 2>&1 || fail "installed: $(cat log)"
rm stage/lib*/plunge/libplunge-vtk.so || fail "no module is installed"
stage/bin/plunge import vti.yaml -o staged.h5 >log 2>&1
[ $? = 2 ] && grep -q "without the VTK library; install libvtk9-dev" log || fail "installed without the module: $(cat log)"

exit $failed
