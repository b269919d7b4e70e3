"""Hands the results of another program to plunge: a standing wave by linear theory, as a result file."""
import numpy as np
import h5py

H, g, rho, length, amplitude = 2.0, 9.81, 1000.0, 4.0, 0.04
k = np.pi / length
omega = np.sqrt(g * k * np.tanh(k * H))
t = np.arange(0, 2.01, 0.1)
x = np.linspace(0, length, 161)
eta = amplitude * np.cos(k * x) * np.cos(omega * t[:, None])  # a surface in each row

with h5py.File("airy.h5", "w") as f:
    f.attrs.update(H=H, g=g, density=rho, spacing=x[1], rest_potential=rho * g * length * H**2 / 2)
    f["surface/time"] = t
    f["surface/first_point"] = len(x) * np.arange(len(t) + 1)  # rows of points where each begins
    f["surface/points"] = np.stack([np.tile(x, len(t)), H + eta.ravel()], axis=1)  # from left to right
    f["walls/first_point"] = [0, 4]
    f["walls/closed"] = [0]
    f["walls/points"] = [[0, 3], [0, 0], [length, 0], [length, 3]]  # the water on their left
    E = rho * g * length * amplitude**2 / 4
    f["series/energy/time"] = t
    f["series/energy/kinetic"] = E * np.sin(omega * t) ** 2
    f["series/energy/potential"] = E * np.cos(omega * t) ** 2 + f.attrs["rest_potential"]
    gauge = f.create_group("series/gauges/middle")
    gauge.attrs["x"] = length / 4
    gauge["time"], gauge["elevation"] = t, H + eta[:, 40]
