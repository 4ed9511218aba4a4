"""Reads the files of a run as their users do, each with its own program, and compares what it finds.

    python3 read_outputs.py h5py|mdanalysis|ase|paraview RUN

Prints one line for each comparison; ends with 1 at the first that fails.
"""

import json
import math
import sys
from pathlib import Path

import h5py
import numpy as np

NM_IN_ANGSTROM, PS = 10, 1e12


def compare(what, found, expected, tolerance):
    found, expected = np.asarray(found, dtype=float), np.asarray(expected, dtype=float)
    if found.shape != expected.shape:
        sys.exit(f"{what}: shape {found.shape}, not {expected.shape}")
    scale = np.abs(expected).max() or 1.0
    apart = np.abs(found - expected).max() / scale
    print(f"{what}: {apart:.1e} apart")
    if not apart <= tolerance:  # nor when it is no number
        sys.exit(f"{what}: {apart:.3e} apart, more than {tolerance}")


def compare_means(what, values, mean, se):
    """The values of several frames against a mean of the summary, by both standard errors."""
    of_frames = np.std(values, ddof=1) / math.sqrt(len(values))
    apart = abs(np.mean(values) - mean) / math.hypot(of_frames, se)
    print(f"{what}: {apart:.1f} standard errors apart")
    if not apart <= 4:
        sys.exit(f"{what}: {np.mean(values)} in the frames, {mean} in the summary")


class Run:
    """What h5py finds in the run's own file and in its H5MD trajectory (SI but for nm and ps)."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.summary = json.loads((self.folder / "summary.json").read_text())
        with h5py.File(self.folder / "trajectory.h5md") as file:
            particles = file["particles/trajectory"]
            self.positions = particles["position/value"][:]
            self.times, self.steps = particles["position/time"][:], particles["position/step"][:]
            self.P = particles["P/value"][:]
            assert particles["position/value"].attrs["unit"] == "nm"
            assert particles["position/time"].attrs["unit"] == "ps"
            assert particles["P/value"].attrs["unit"] == "Pa", particles["P/value"].attrs["unit"]

    def compare_pressure(self, frames):
        compare_means("P of the frames and of the summary", [np.mean(P) for P in frames],
                      self.summary["P_internal_Pa"], self.summary["P_internal_Pa_se"])


def read_with_h5py(run):
    with h5py.File(run.folder / "run.h5") as file:
        columns = [name.decode() if isinstance(name, bytes) else name for name in
                   file["thermodynamics"].attrs["columns"]]
        table = dict(zip(columns, file["thermodynamics"][:].T))
    dt = run.summary["dt_s"]
    compare("P of run.h5 and of the summary", table["P_Pa"].mean(), run.summary["P_Pa"], 1e-9)
    compare("steps and times of the samples", table["time_s"], table["step"] * dt, 1e-9)
    compare("steps and times of the frames", run.times, run.steps * dt * PS, 1e-9)
    run.compare_pressure(run.P)


def read_with_mdanalysis(run):
    import MDAnalysis

    universe = MDAnalysis.Universe(str(run.folder / "trajectory.h5md"))
    frames = [(frame.positions.copy(), frame.time, frame.dimensions[0]) for frame in universe.trajectory]
    compare("positions", [frame[0] for frame in frames], run.positions * NM_IN_ANGSTROM, 1e-6)
    compare("times", [frame[1] for frame in frames], run.times, 1e-6)
    assert all(edge > 0 for _, _, edge in frames)


def read_with_ase(run):
    import ase.io

    frames = ase.io.read(run.folder / "trajectory.xyz", index=":")
    compare("positions", [atoms.positions for atoms in frames], run.positions * NM_IN_ANGSTROM, 1e-12)
    compare("times", [atoms.info["time"] for atoms in frames], run.times, 1e-12)
    compare("P", [atoms.arrays["P_Pa"] for atoms in frames], run.P, 1e-12)
    assert all(atoms.pbc.all() for atoms in frames)
    run.compare_pressure([atoms.arrays["P_Pa"] for atoms in frames])


def read_with_paraview(run):
    from paraview import simple
    from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject
    from paraview.servermanager import Fetch

    series = simple.OpenDataFile(str((run.folder / "trajectory.hdf.series").resolve()))
    compare("times", list(series.TimestepValues), run.times, 1e-9)
    pressures = []
    for k, time in enumerate(series.TimestepValues):
        series.UpdatePipeline(time)
        data = WrapDataObject(Fetch(series))
        compare(f"positions of frame {k}", np.asarray(data.Points), run.positions[k], 1e-12)
        pressures.append(np.asarray(data.PointData["P_Pa"]).copy())
    compare("P", pressures, run.P, 1e-12)
    run.compare_pressure(pressures)
    render(simple, series, run.folder / "particles.png")


def render(simple, series, file):
    """One frame as a picture, coloured by P; a picture of one colour shows nothing."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    view = simple.CreateView("RenderView")
    view.ViewSize = [400, 300]
    shown = simple.Show(series, view)
    shown.Representation = "Point Gaussian"
    shown.GaussianRadius = 0.2
    simple.ColorBy(shown, ("POINTS", "P_Pa"))
    simple.ResetCamera(view)
    simple.SaveScreenshot(str(file), view)
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    colours = len(np.unique(pixels, axis=0))
    print(f"{file.name}: {colours} colours")
    if colours < 50:
        sys.exit(f"{file.name} shows nothing")


if __name__ == "__main__":
    readers = {"h5py": read_with_h5py, "mdanalysis": read_with_mdanalysis, "ase": read_with_ase,
               "paraview": read_with_paraview}
    readers[sys.argv[1]](Run(sys.argv[2]))
