#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each test costs, in seconds of CPU: runs tests of a build one after another, most costly last in the list.

  scripts/dev/test_costs.py                          all that ./test.sh runs of the Release build
  scripts/dev/test_costs.py --build sanitize --only 'cli_.*' --jobs 2
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOT_RUN = {"release": {"long"}, "sanitize": {"long", "slow"}}


def tests_of(folder):
    told = subprocess.run(["ctest", "--show-only=json-v1"], cwd=folder, capture_output=True, text=True, check=True)
    for test in json.loads(told.stdout)["tests"]:
        if "command" in test:
            yield test["name"], test["command"], {one["name"]: one["value"] for one in test.get("properties", [])}


def run(name, command, properties):
    environment = dict(os.environ, **dict(pair.split("=", 1) for pair in properties.get("ENVIRONMENT", [])))
    child = subprocess.Popen(command, cwd=properties.get("WORKING_DIRECTORY", "."), env=environment,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    return name, used.ru_utime + used.ru_stime, os.waitstatus_to_exitcode(status)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="release", choices=NOT_RUN)
    parser.add_argument("--only", default=".*", help="regular expression of whole names")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    chosen = [test for test in tests_of(ROOT / "build" / options.build) if re.fullmatch(options.only, test[0]) and
              not NOT_RUN[options.build] & set(test[2].get("LABELS", []))]
    costs = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for done in concurrent.futures.as_completed([pool.submit(run, *test) for test in chosen]):
            costs.append(done.result())
            print(f"{len(costs)} of {len(chosen)}: {costs[-1][0]}", file=sys.stderr, flush=True)
    for name, seconds, status in sorted(costs, key=lambda cost: cost[1]):
        print(f"{seconds:8.1f} s  {name}" + (f"  FAILED ({status})" if status else ""))
    print(f"{sum(cost[1] for cost in costs):8.1f} s  all")
    return any(status for _, _, status in costs)


if __name__ == "__main__":
    sys.exit(main())
