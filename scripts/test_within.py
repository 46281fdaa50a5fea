#!/usr/bin/env python3
"""The tests of a build folder for as long as there is time, as many at once as there are processors, those that take least first.

Usage: test_within.py FOLDER SECONDS SELECTION…

SELECTION: -R or -E with a pattern of names, as for ctest. Programs that CMake gives a cost run suite by suite, so that of a long one, too, runs what fits. What is
still running when the time is over is ended and counted as not run, and so is what was not built; neither is a failure.
"""
import concurrent.futures
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

PASSED, FAILED, NOT_RUN = "passed", "failed", "not run"


def listed(folder, selection):
    """Cost, name and command of each test that CMake knows, in increasing cost; no command where the program was not built."""
    answer = subprocess.run(["ctest", "--test-dir", folder, "--show-only=json-v1", *selection], check=True, capture_output=True, text=True)
    tests = []
    for test in json.loads(answer.stdout)["tests"]:
        properties = {entry["name"]: entry["value"] for entry in test.get("properties", [])}
        command = test.get("command", [])
        tests.append((float(properties.get("COST", 0)), test["name"], command if command and pathlib.Path(command[0]).is_file() else []))
    return sorted(tests)


def parts(cost, name, command):
    """What is run at once: a program, or one suite of a long one."""
    if not cost or not command:
        return [(name, command)]
    lines = subprocess.run([*command, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout.splitlines()
    suites = [line.split()[0] for line in lines if line.split("#")[0].rstrip().endswith(".") and not line.startswith(" ")]
    return [(f"{name} {suite[:-1]}", [*command, f"--gtest_filter={suite}*"]) for suite in suites]


def run(name, command, folder, end):
    begin = time.monotonic()
    if not command or begin >= end:
        return name, NOT_RUN
    # A session of its own, so that programs which the test started end with it.
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
    try:
        output, _ = process.communicate(timeout=end - begin)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return name, NOT_RUN
    result = FAILED if process.returncode else PASSED
    if process.returncode:
        print(output.decode(errors="replace"))
    print(f"{result} {time.monotonic() - begin:7.1f} s  {name}", flush=True)
    return name, result


def main():
    folder, seconds, *selection = sys.argv[1:]
    end = time.monotonic() + float(seconds)
    work = [part for test in listed(folder, selection) for part in parts(*test)]
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        results = list(pool.map(lambda part: run(*part, folder, end), work))
    names = {wanted: [name for name, result in results if result == wanted] for wanted in (PASSED, FAILED, NOT_RUN)}
    print(f"as programs, or suites of the long ones; not run for lack of time, {len(names[NOT_RUN])}: {', '.join(names[NOT_RUN]) or 'none'}")
    for name in names[FAILED]:
        print(f"failed: {name}")
    print(f"{len(names[PASSED])} passed, {len(names[FAILED])} failed")
    return 1 if names[FAILED] else 0


if __name__ == "__main__":
    sys.exit(main())
