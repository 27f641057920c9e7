"""An ensemble that other authors have published with their own fits (data/published): ours agree.

fit_published.py PROGRAM SOURCE
"""

import csv
import json
import math
import subprocess
import sys
from pathlib import Path

program, file = sys.argv[1], Path(sys.argv[2]) / "data/published/ias15_kepler.csv"

# docs/VALIDATION.md of cft-rebound, the horizon entry: least squares of log-percentiles over all 64 members and 100
# samples, without intervals; p90 = factor · orbits^exponent
AUTHORS = {
    "energy": {"p90": (1.729e-16, 0.540), "median": 0.477},
    "phase": {"p90": (3.212e-16, 1.471), "median": 1.494},
}
NORMAL_P90 = 1.6449  # of |N(0, 1)|
CHI2_16 = (0.157, 2.98)  # of a mean of 16 squares, 5·10⁻⁵ on either side


def rms_at(quantity, time):
    with open(file, encoding="ascii") as lines:
        errors = [float(r["error"]) for r in csv.DictReader(lines) if r["quantity"] == quantity and float(r["time"]) == time]
    assert len(errors) == 16, len(errors)
    return math.sqrt(sum(e * e for e in errors) / len(errors))


def main():
    said = subprocess.run([program, "fit", str(file), "--format", "json"], check=True, capture_output=True, text=True)
    rows = {row["quantity"]: row for row in json.loads(said.stdout)}
    for quantity, law in AUTHORS.items():
        factor, exponent = law["p90"]
        low, high = rows[quantity]["growth"]["ci"]
        print(f"{quantity}: q = {rows[quantity]['growth']['exponent']:.3f} ({low:.3f} … {high:.3f}); authors {exponent}, {law['median']}")
        assert low < exponent < high and low < law["median"] < high, quantity
        assert high - low < 0.3, "the interval is too wide to tell a walk from a drift, or a phase from either"
        for time in (995.215629244, 9952.15629244 * 2, 99521.5629244):
            time = min((float(t) for t in times()), key=lambda t: abs(t - time))
            ratio = (rms_at(quantity, time) / (factor * time**exponent / NORMAL_P90)) ** 2
            print(f"  at {time:.0f} orbits: (RMS / theirs)² = {ratio:.2f}")
            assert CHI2_16[0] < ratio < CHI2_16[1], (quantity, time, ratio)
        assert f"{quantity}: no error is negative" in said.stderr, "they are absolute values, and that is said"


def times():
    with open(file, encoding="ascii") as lines:
        return {r["time"] for r in csv.DictReader(lines)}


main()
