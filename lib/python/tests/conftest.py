"""What the tests share: the C++ program, whose JSON the package is held against."""
import json
import os
import subprocess

import pytest
from hypothesis import settings

# One examples' database less to write; the first slow example of a process is no fault.
settings.register_profile("wavecurve", deadline=None, database=None, max_examples=60)
settings.load_profile("wavecurve")


@pytest.fixture(scope="session")
def program():
    """Runs the program and reads its JSON; exit code 1 says that something differs, which is a result."""
    path = os.environ["WAVECURVE_PROGRAM"]

    def run(*arguments, text=False):
        done = subprocess.run([path, *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
        return done.stdout if text else json.loads(done.stdout)

    return run
