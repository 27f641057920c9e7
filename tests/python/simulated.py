"""Ensembles of known laws, simulated by another program than the one that is tested, as csv and as HDF5.

    e(t) = (drift + slope·N) t + diffusion·W(t) + noise·N

simulated.py FOLDER writes walk.csv, walk.h5 and so on, each with many ensembles of one law.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

ENSEMBLES, MEMBERS, SAMPLES, LAST = 300, 24, 20, 10_000


@dataclass
class Law:
    name: str
    seed: int
    drift: float = 0
    slope: float = 0  # standard deviation over members
    diffusion: float = 0
    noise: float = 0


LAWS = [
    Law("walk", 1, diffusion=1e-16),
    Law("drift", 2, drift=-4e-19, diffusion=1e-16),
    Law("slopes", 3, slope=3e-18, diffusion=1e-16),
    Law("noise", 4, noise=1e-15, diffusion=1e-19),
]


def times():
    return np.unique(np.round(np.geomspace(1, LAST, SAMPLES)))


def simulated(law):
    """ENSEMBLES × MEMBERS × times"""
    random, t = np.random.Generator(np.random.PCG64(law.seed)), times()
    shape = (ENSEMBLES, MEMBERS, len(t))
    walk = np.cumsum(random.standard_normal(shape) * np.sqrt(np.diff(t, prepend=0)), axis=2)
    slopes = law.drift + law.slope * random.standard_normal(shape[:2] + (1,))
    return slopes * t + law.diffusion * walk + law.noise * random.standard_normal(shape)


def write_csv(file, law, errors):
    """Long form: one error a line."""
    with open(file, "w", encoding="ascii") as out:
        out.write("quantity,member,time,error\n")
        for k, ensemble in enumerate(errors):
            for i, member in enumerate(ensemble):
                out.writelines(f"{law.name}-{k:03},{i},{t:g},{e!r}\n" for t, e in zip(times(), member.tolist()))


def write_hdf5(file, law, errors):
    """A group an ensemble; by turns members × times and times × members, contiguous and compressed."""
    with h5py.File(file, "w") as out:
        out["time"] = times()
        for k, ensemble in enumerate(errors):
            data = ensemble if k % 2 == 0 else ensemble.T
            storage = {} if k % 3 == 0 else {"compression": "gzip", "chunks": (5, 7)}
            out.create_dataset(f"{law.name}/error-{k:03}", data=data, **storage)


def write_all(folder):
    for law in LAWS:
        errors = simulated(law)
        write_csv(Path(folder) / f"{law.name}.csv", law, errors[:30])
        write_hdf5(Path(folder) / f"{law.name}.h5", law, errors)


if __name__ == "__main__":
    write_all(sys.argv[1])
