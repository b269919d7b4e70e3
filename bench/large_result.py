#!/usr/bin/env python3
"""A result as large as that of a fine run, of a made-up sloshing: for measuring plunge compare, diff and movie.

    large_result.py OUT.h5 [SPACINGS A HEIGHT] [OUTPUTS] [SEED]
"""
import sys

import h5py
import numpy as np

path = sys.argv[1]
side, outputs, seed = (int(v) for v in sys.argv[2:] + ["200", "131", "1"][len(sys.argv) - 2:])
rng = np.random.default_rng(seed)
H, g, density = 0.6, 9.81, 1000.0
dx, T = H / side, (H / g) ** 0.5
x0, y0 = (a.ravel() for a in np.meshgrid((np.arange(2 * side) + 0.5) * dx, (np.arange(side) + 0.5) * dx))
n = x0.size
times = 0.05 * T * np.arange(outputs)
stored = dict(shuffle=True, compression=1)  # as runs of plunge are


def table(group, name, width, units):
    shape = (n * outputs, width) if width else (n * outputs,)
    made = group.create_dataset(name, shape, "f8", chunks=(4096, width) if width else (4096,), **stored)
    made.attrs["units"] = units
    return made


with h5py.File(path, "w", libver="latest") as f:
    f.attrs.update(H=H, g=g, density=density, spacing=dx, run=f"large{seed}", solver="made up", rest_potential=0.0)
    walls = f.create_group("walls")
    walls["points"] = np.array([[0, 2 * H], [0, 0], [2 * H, 0], [2 * H, 2 * H]])
    walls["first_point"], walls["closed"] = np.array([0, 4]), np.zeros(1, np.uint8)
    vtk = f.create_group("VTKHDF")
    steps, data = vtk.create_group("Steps"), vtk.create_group("PointData")
    steps["Values"], steps["PointOffsets"] = times, n * np.arange(outputs)
    vtk["NumberOfPoints"] = np.full(outputs, n)
    points = table(vtk, "Points", 3, "m")
    field = {name: table(data, name, width, units) for name, width, units in (
        ("pressure", 0, "Pa"), ("density", 0, "kg/m^3"), ("mass", 0, "kg/m"), ("volume", 0, "m^2"), ("velocity", 3, "m/s"))}
    xs, surface = np.linspace(0, 2 * H, 4 * side), []
    for k, t in enumerate(times):
        rows = slice(k * n, (k + 1) * n)
        height = lambda x: 1 + 0.1 * np.sin(2 * t / T) * np.cos(np.pi * x / (2 * H))
        noise = lambda size, of=1e-3 * dx: rng.normal(0, of, size)
        points[rows] = np.c_[x0 + noise(n), y0 * height(x0) + noise(n), np.zeros(n)]
        field["pressure"][rows] = density * g * (H - y0) + noise(n, 1)
        field["density"][rows] = density + noise(n, 1)
        field["mass"][rows] = density * dx * dx
        field["volume"][rows] = dx * dx * (1 + noise(n, 1e-4))
        field["velocity"][rows] = np.c_[noise(n, 0.1), noise(n, 0.1), np.zeros(n)]
        surface.append(np.c_[xs, H * height(xs) + noise(xs.size)])
    s = f.create_group("surface")
    s["time"], s["first_point"] = times, xs.size * np.arange(outputs + 1)
    s.create_dataset("points", data=np.vstack(surface), chunks=(4096, 2), **stored)
    rows = np.linspace(0, times[-1], 5000)
    energy, run = f.create_group("series/energy"), f.create_group("series/run")
    for name, values in (("time", rows), ("kinetic", 100 + np.sin(rows / T)), ("potential", 100 - np.sin(rows / T))):
        energy[name] = values
    run["time"], run["volume"] = rows, np.full(rows.size, 2 * H * H)
