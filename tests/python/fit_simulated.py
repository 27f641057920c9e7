"""`brouwer fit` on ensembles that another program has simulated: its intervals hold the true values, and its tests alarm,
as often as they promise, within the bounds of the binomial law (10⁻⁴ on either side). Seeds are fixed.

fit_simulated.py PROGRAM [SOURCE]
"""

import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import simulated

program = sys.argv[1]
failures = []


def tail(k, n, p, upwards):
    """P(X ≥ k) or P(X ≤ k) of the binomial law."""
    log = lambda i: math.lgamma(n + 1) - math.lgamma(i + 1) - math.lgamma(n - i + 1) + i * math.log(p) + (n - i) * math.log1p(-p)
    return sum(math.exp(log(i)) for i in (range(k, n + 1) if upwards else range(k + 1)))


def expect(law, what, hits, low, high=None):
    """The chance of a hit is between low and high."""
    count, n = sum(hits), len(hits)
    good = tail(count, n, low, upwards=False) > 1e-4 and tail(count, n, high or low, upwards=True) > 1e-4
    print(f"{law:8} {what:44} {count:4} of {n}{'' if good else '   <-- not within the bounds of ' + str((low, high or low))}")
    if not good:
        failures.append((law, what))


def fit(file):
    said = subprocess.run([program, "fit", str(file), "--format", "json"], check=True, capture_output=True, text=True)
    return json.loads(said.stdout)


def holds(interval, value):
    return interval[0] <= value <= interval[1]


def judge(law, rows):
    expect(law.name, "interval of the drift holds the drift", [holds(r["drift"]["ci"], law.drift) for r in rows], 0.95)
    if law.diffusion > 1e-18:
        expect(law.name, "interval of σ holds σ", [holds(r["diffusion"]["ci"], law.diffusion) for r in rows], 0.95)
    if law.drift == 0:
        expect(law.name, "a drift is seen at level 0.05", [r["drift"]["p"] < 0.05 for r in rows], 0.05)
        expect(law.name, "verdict drift, at level 0.001", [r["verdict"] == "drift" for r in rows], 0.001)
    if law.name == "walk":
        expect(law.name, "slopes are seen at level 0.05", [r["persistence"]["p"] < 0.05 for r in rows], 0.05)
        # 24 members: the bootstrap's interval covers 0.94 (analysis/growth/power_law.hpp)
        expect(law.name, "interval of q holds 1/2", [holds(r["growth"]["ci"], 0.5) for r in rows], 0.92, 0.95)
        expect(law.name, "verdict random walk", [r["verdict"] == "random walk" for r in rows], 0.9, 0.999)
    if law.name == "drift":  # β√(M t_J)/σ = 1.96: half of them are seen at level 0.05
        power = [r["drift"]["p"] < 0.05 for r in rows]
        expect(law.name, "the drift is seen at level 0.05", power, 0.46)  # noncentral t, 23 degrees of freedom: 0.463
    if law.name == "slopes":
        expect(law.name, "verdict persistent slopes", [r["verdict"] == "persistent slopes" for r in rows], 0.99, 0.999)
    if law.name == "noise":
        expect(law.name, "verdict bounded", [r["verdict"] == "bounded" for r in rows], 0.95, 0.9999)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        simulated.write_all(folder)
        for law in simulated.LAWS:
            rows = fit(folder / f"{law.name}.h5")
            assert len(rows) == simulated.ENSEMBLES, len(rows)
            judge(law, rows)
            as_text = fit(folder / f"{law.name}.csv")
            for text, binary in zip(as_text, rows):
                for key in ("drift", "diffusion", "persistence", "growth", "rms_final", "verdict"):
                    assert text[key] == binary[key], f"{law.name}: {key} differs between csv and HDF5"
    assert not failures, failures


main()
