"""What the records of the trials have in common (docs/reliability/): the day and the revision that they were made at."""
import datetime
import json
import pathlib
import subprocess


def write_record(path, figures):
    revision = subprocess.run(["git", "rev-parse", "HEAD"], capture_output=True, text=True, check=False,
                              cwd=pathlib.Path(__file__).parent).stdout.strip()
    stamped = {"date": datetime.date.today().isoformat(), "revision": revision or "unknown", **figures}
    pathlib.Path(path).write_text(json.dumps(stamped, indent=1) + "\n")
