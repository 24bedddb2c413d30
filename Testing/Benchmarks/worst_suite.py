# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the worst cases on one core, each in a process of its own, and writes the document of what they take.

usage: worst_suite.py WORST_CASES BUILD_FOLDER DOCUMENT.md [--tiny]

The results stay in BUILD_FOLDER/benchmarks as JSON. --tiny: on tiny surfaces, to try whether it runs.
"""

import datetime
import json
import os
import signal
import subprocess
import sys
import time

import worst_cases
import worst_report
from report import commit


def processor_seconds(pid):
    with open(f"/proc/{pid}/stat") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def wait_for(process):
    """Until it ends, or has taken the limit. The system's own limit would make the process's clock coarse."""
    while process.poll() is None:
        if processor_seconds(process.pid) > worst_report.LIMIT:
            process.kill()
        time.sleep(0.05)


def measured(program, case, tiny):
    """What the program told, with "ended" for how: well, with an error, or by the limit."""
    print(case.name, flush=True)
    with subprocess.Popen([program, *tiny, *map(str, case.command)], stdout=subprocess.PIPE, text=True) as run:
        wait_for(run)
        lines = run.stdout.read().splitlines()
    if run.returncode not in (0, 1, -signal.SIGKILL):
        raise RuntimeError(f"{program} ended with {run.returncode}")
    found = {"ended": "well" if run.returncode == 0 else "error" if run.returncode > 0 else "limit"}
    for line in lines:
        name, value = line.split(" ", 1)
        found[name] = value if name == "error" else float(value)
    print(found, flush=True)
    return found


def main(program, build, document, *tiny):
    results = os.path.join(build, "benchmarks")
    os.makedirs(results, exist_ok=True)
    found = {"load": os.getloadavg(), "cores": os.cpu_count(), "commit": commit(),
             "date": str(datetime.date.today())}
    # What is started from here on inherits the core.
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    cases = [*(case for cases in worst_cases.TIMED.values() for case in cases), *worst_cases.ERRORS]
    found["cases"] = {case.name: measured(program, case, tiny) for case in cases}
    with open(os.path.join(results, "worst.json"), "w") as stream:
        json.dump(found, stream, indent=1)
    worst_report.write(found, document)
    print("Wrote", document)


if __name__ == "__main__":
    main(*sys.argv[1:])
