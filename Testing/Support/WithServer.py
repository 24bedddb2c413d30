# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a command with a ParaView server of 2 ranks, whose URL is put in the place of URL.

usage: WithServer.py MPIEXEC PVSERVER COMMAND ... URL ...
"""

import os
import socket
import subprocess
import sys

MPIEXEC, PVSERVER, *COMMAND = sys.argv[1:]

with socket.socket() as free:
    # By number: a bare system need not know the name localhost.
    free.bind(("127.0.0.1", 0))
    port = free.getsockname()[1]

server = subprocess.Popen(
    [MPIEXEC, "-n", "2", "--oversubscribe", "--allow-run-as-root",
     PVSERVER, f"--server-port={port}", "--force-offscreen-rendering"],
    stdout=subprocess.PIPE, text=True, env={**os.environ, "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
                                         "OMPI_MCA_mpi_yield_when_idle": "1"})
for line in server.stdout:
    if "Accepting connection" in line:
        break
result = subprocess.run(
    [argument.replace("URL", f"cs://127.0.0.1:{port}") for argument in COMMAND], check=False)
try:
    # It ends when its client has gone.
    server.wait(timeout=30)
except subprocess.TimeoutExpired:
    server.kill()
sys.exit(result.returncode)
