"""Makes ias15_kepler.csv from the tables that cft-rebound publishes, results/horizon/ens64_fixed/m0.csv … m15.csv.

    ias15_kepler.py FOLDER > ias15_kepler.csv

https://github.com/loganw234/cft-rebound, commit 358742c98f43368e96daa7b7933580394eea1c5c, GPL-3.0-or-later, copyright
2026 the cft-rebound contributors. REBOUND's IAS15 in double precision with the fixed step 1/16 over 10⁷ steps of Kepler's
problem, e = 1/2: 64 members whose planet starts 2k ulps aside, of which the first 16 are taken, and of their 100 samples
those that are about evenly spaced in log t. Both columns are absolute values: the energy's error relative to the start's,
and the time by which the planet is ahead or behind along its orbit, in periods. Times are in orbits.
"""

import csv
import sys
from pathlib import Path

MEMBERS = 16
SAMPLES = (1, 2, 3, 5, 8, 13, 20, 32, 50, 70, 100)
COLUMNS = {"energy": "rel_energy_err", "phase": "rel_phase_err"}


def main(folder):
    print("quantity,member,time,error")
    for quantity, column in COLUMNS.items():
        for member in range(MEMBERS):
            with open(Path(folder) / f"m{member}.csv", encoding="ascii") as file:
                rows = {int(row["sample"]): row for row in csv.DictReader(file)}
            for sample in SAMPLES:
                print(f"{quantity},{member},{rows[sample]['orbits']},{rows[sample][column]}")


main(sys.argv[1])
