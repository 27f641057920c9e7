"""The Python of docs/reading-results.md, run as it stands there: what it finds is what the program's table says.

reading_results.py PROGRAM SOURCE
"""

import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

program, source = sys.argv[1], Path(sys.argv[2])

STUDY = """question = "A toy?"
[system.rigid_body]
[integrate]
methods = ["elliptic-naive", "elliptic-three-constants", "dmv-2"]
step = 0.01
steps = 2000
[ensemble]
members = 150
seed = 1
perturb = { momentum = { uniform = 1e-2 } }
[observe]
quantities = ["energy", "casimir", "state"]
reference = { arithmetic = "float128", members = 3 }
samples = { count = 16 }
"""


def run(*arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def assert_near(found, expected, tolerance, what):
    if expected is None:
        return
    assert math.isclose(found, expected, rel_tol=tolerance, abs_tol=1e-300), f"{what}: {found!r}, not {expected!r}"


def compare_with_table(document, result):
    rows = {(row["method"], row["quantity"]): row for row in json.loads(run("table", result, "--format", "json"))}
    compared = 0
    for labels, steps, errors in document["cells"](result):
        for quantity, e in errors.items():
            row = rows[labels["method"].decode(), quantity]
            rms, exponent = document["growth"](steps, e)
            slope, error = document["drift"](steps, e)
            assert len(e) == row["members"], f"{quantity}: {len(e)} members, not {row['members']}"
            assert_near(rms[-1], row["rms_final"], 1e-12, "RMS")
            whole = row["course"]["whole_drift"]  # where the mean is no straight line β is of another part, or less sure
            assert_near(slope, row["drift"]["per_step"] if whole is None else whole, 1e-12, "drift")
            if whole is None:
                assert_near(slope / error, row["drift"]["t"], 1e-6, "t")
            assert_near(exponent, row["growth"]["exponent"], 1e-9, "exponent")
            compared += 1
    assert compared == len(rows) > 10, f"{compared} of {len(rows)} rows were compared"


def compare_with_fit(document, result, folder):
    labels, steps, errors = next(document["cells"](result))
    document["write_ensemble"](folder / "errors.h5", steps, errors["energy"])
    fitted = json.loads(run("fit", str(folder / "errors.h5"), "--format", "json"))[0]
    own = json.loads(run("table", result, "--format", "json"))[0]
    for key in ("drift", "diffusion", "growth"):
        assert fitted[key] == own[key], f"{key}: {fitted[key]}, not {own[key]}"


def main():
    text = (source / "docs/reading-results.md").read_text(encoding="utf-8")
    snippets = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert len(snippets) == 2, f"{len(snippets)} snippets"
    document = {}
    for snippet in snippets:
        exec(snippet, document)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "toy.toml").write_text(STUDY)
        result = str(folder / "result")
        run("run", str(folder / "toy.toml"), "-o", result, "--no-figures")
        compare_with_table(document, result)
        compare_with_fit(document, result, folder)


main()
