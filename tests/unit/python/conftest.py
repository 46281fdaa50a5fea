import pathlib
import subprocess
import os

import pytest

import railpem

ROOT = pathlib.Path(__file__).resolve().parents[3]
WEI = ROOT / "cases/wei2016"


@pytest.fixture
def case():
    """Case 3 of Wei et al. 2016 on coarse lines: quick, everything in it."""
    return railpem.Case(WEI / "case3.toml", set=["frequency.step_hz=1.0"])


@pytest.fixture
def program():
    """The program of the same build: what Python gives must be what it writes."""
    path = os.environ["RAILPEM_PROGRAM"]

    def run(*arguments, status=0):
        done = subprocess.run([path, *map(str, arguments)], capture_output=True, text=True, check=False)
        assert done.returncode == status, done.stderr
        return done.stderr if status in (1, 2) else done.stdout  # 3: errors in the data, the report is whole

    return run
