#!/usr/bin/env python3
"""Every verb while the machine fails under it: no memory, no disk, killed, files and folders that refuse.

Whatever happens: the exit status is 0, 1 or 2 and anything but 0 says why (a kill excepted); every file that bears the name of a result
is a whole result, of this run or of the one before; after a refusal no new folder is there; and the same command afterwards gives what
an undisturbed one gives.

Usage: faults.py RAILPEM FAIL_ALLOCATION.so [--thorough] [VERB…]
"""
import math
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASE1, CASE2 = (ROOT / f"cases/wei2016/case{i}.toml" for i in (1, 2))
QUICK = ["--set", "frequency.step_hz=2.0"]
SWEEP = """case = "{case}"
[[vary]]
key = "vehicle.payload_kg"
from = 0.0
to = 8000.0
count = 400
[[keep]]
response = "wheel_1"
"""


class Verb:
    """A verb with arguments that make it quick. `inputs`: what may be taken away from it; `volatile`: files that tell times;
    `resumes`: it goes on where it was."""

    def __init__(self, name, arguments, inputs, out=True, volatile=(), resumes=()):
        self.name, self.arguments, self.inputs, self.out = name, [str(a) for a in arguments], inputs, out
        self.volatile, self.resumes = set(volatile), resumes

    def command(self, program, folder):
        return [program, self.name, *self.arguments, *(["--out", str(folder)] if self.out else [])]


def verbs(program, top):
    sweep = top / "many.toml"
    sweep.write_text(SWEEP.format(case=CASE1))
    record = top / "record"
    subprocess.run([program, "simulate", CASE1, "--seconds", "20", "--seed", "1", "--out", record], check=True)
    return [
        Verb("solve", [CASE1, CASE2, "--bands", *QUICK], [CASE1]),
        Verb("static", [CASE2, *QUICK], [CASE2]),
        Verb("receptance", [CASE1, "--lines", "60"], [CASE1]),
        Verb("compare", [CASE1, CASE2], [CASE2]),
        Verb("sweep", [sweep, *QUICK], [sweep], resumes=("many.unfinished",)),
        Verb("simulate", [CASE1, "--seconds", "10", "--seed", "1", "--format", "hdf5"], [CASE1]),
        Verb("inspect", [record, "--case", CASE1, "--json"], [record / "recording.csv", record / "recording.toml"]),
        Verb("diagnose", [CASE1, record, "--most-effects", "1", "--window", "2"], [record / "recording.csv"], volatile=("diagnosis.json", "report.html")),
        Verb("prove", ["--trials", "1", "--quick", "--seconds", "20"], [], volatile=("0000.json", "score.json", "trials.csv"), resumes=("proof.json", "truth", "trials")),
        Verb("validate", [CASE1, sweep, record / "recording.toml"][:1], [CASE1], out=False),
        Verb("describe", ["effects"], [], out=False),
    ]


def run(command, environment=None, before=None, seconds=600, **options):
    return subprocess.run([str(word) for word in command], env={**os.environ, "OMP_NUM_THREADS": "2", **(environment or {})}, preexec_fn=before,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=seconds, check=False, **options)


def files_of(folder):
    """Contents by name, the folder's own name in them (of the command) left out."""
    return {str(path.relative_to(folder)): path.read_bytes().replace(str(folder).encode(), b"FOLDER") for path in sorted(folder.rglob("*"))
            if path.is_file()} if folder.exists() else {}


class Faults:
    def __init__(self, program, preload, top, thorough):
        self.program, self.preload, self.top, self.thorough = program, preload, top, thorough
        self.expected, self.seconds, self.findings, self.checks = {}, 0.0, [], 0

    def folder(self):
        return pathlib.Path(tempfile.mkdtemp(dir=self.top)) / "out"

    def find(self, verb, fault, what):
        self.findings.append(f"{verb.name}, {fault}: {what}")

    def undisturbed(self, verb):
        folder, begin = self.folder(), time.monotonic()
        done = run(verb.command(self.program, folder))
        self.seconds = time.monotonic() - begin
        assert done.returncode == 0, done.stderr
        self.expected = files_of(folder)

    def check_files(self, verb, fault, folder, earlier=None):
        """Final names hold whole results; a partial file has another name."""
        for name, content in files_of(folder).items():
            base = pathlib.Path(name).name
            if base.endswith(".partial") or ".unfinished" in base:
                continue
            whole = name in self.expected and (base in verb.volatile or content == self.expected[name])
            if not whole and not (earlier and earlier.get(name) == content):
                self.find(verb, fault, f"{name} is not a whole result")

    def check_end(self, verb, fault, done, folder, allowed=(0, 1, 2)):
        self.checks += 1
        if done.returncode not in allowed:
            self.find(verb, fault, f"exit status {done.returncode}: {done.stderr.strip()[-200:]}")
        elif done.returncode != 0 and not done.stderr.strip():
            self.find(verb, fault, f"exit status {done.returncode} without a word")
        if done.returncode > 0 and folder.exists() and not verb.resumes and not files_of(folder).keys() - set():
            self.find(verb, fault, "an empty folder stays")
        self.check_files(verb, fault, folder)
        if done.returncode == 0 and verb.out and set(files_of(folder)) - {n for n in files_of(folder) if n.endswith(".partial")} != set(self.expected):
            self.find(verb, fault, "said to be done, but files are missing or left over")
        shutil.rmtree(folder.parent, ignore_errors=True)

    def allocations(self, verb):
        counted = self.top / "count"
        base = {"LD_PRELOAD": self.preload, "OMP_NUM_THREADS": "1"}
        folder = self.folder()
        run(verb.command(self.program, folder), {**base, "RAILPEM_COUNT_IN": str(counted)})
        total = int(counted.read_text())
        slow = self.seconds > 3.0
        points = 100 if self.thorough else 3 if slow else 30
        for mode in ({}, {"RAILPEM_FAIL_ON": "1"}):
            places = {max(1, round(math.exp(random.uniform(0.0, math.log(total))))) for _ in range(points)}
            for place in sorted(places):
                folder = self.folder()
                done = run(verb.command(self.program, folder), {**base, **mode, "RAILPEM_FAIL_AT": str(place)})
                # Libraries may do without what they did not get, so 0 is allowed, and 2 where a reader's child process had no memory.
                self.check_end(verb, f"allocation {place}{' and all after' if mode else ''} of {total} fails", done, folder)

    def full_disk(self, verb):
        largest = max((len(content) for content in self.expected.values()), default=4096)
        for limit in (0, 512, largest // 3, largest - 1):
            def before(limit=limit):
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
            folder = self.folder()
            self.check_end(verb, f"files end at {limit} bytes", run(verb.command(self.program, folder), before=before), folder)
        with open("/dev/full", "w") as full:
            folder = self.folder()
            done = subprocess.run(verb.command(self.program, folder), stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            if verb.name in ("inspect", "describe", "validate", "diagnose", "prove") and done.returncode != 1:
                self.find(verb, "standard output is full", f"exit status {done.returncode}")
            self.checks += 1

    def small_disk(self, verb):
        """A file system of 64 KiB, where root may make one."""
        disk = self.top / "disk"
        disk.mkdir(exist_ok=True)
        if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk], stderr=subprocess.DEVNULL, check=False).returncode:
            return
        try:
            (disk / "ballast").write_bytes(b"x" * 56000)
            folder = disk / "in/out"
            done = run(verb.command(self.program, folder))
            self.check_end(verb, "the disk is full", done, folder)
        finally:
            subprocess.run(["umount", disk], check=True)

    def killed(self, verb):
        for share in random.sample([0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 1.0], 7 if self.thorough else 3 if self.seconds < 3.0 else 1):
            folder = self.folder()
            child = subprocess.Popen(verb.command(self.program, folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(share * self.seconds)
            child.send_signal(signal.SIGKILL)
            child.wait()
            self.check_files(verb, f"killed at {share:.0%}", folder)
            again = run(verb.command(self.program, folder))
            self.check_end(verb, f"killed at {share:.0%}, run again", again, folder, allowed=(0,))

    def earlier_results_stay(self, verb):
        """A run that fails leaves the results of the one before as they were."""
        if not verb.out or verb.resumes:
            return
        folder = self.folder()
        folder.mkdir()
        for name in self.expected:
            (folder / name).write_text("earlier, written by railpem")
        before = files_of(folder)
        def small():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
        done = run(verb.command(self.program, folder), before=small)
        self.checks += 1
        if done.returncode != 1 or files_of(folder) != before:
            self.find(verb, "a run that fails over earlier results", f"exit status {done.returncode}, {sorted(files_of(folder))}")
        shutil.rmtree(folder.parent)

    def refusing_inputs(self, verb):
        for path in verb.inputs:
            for kind in ("gone", "a folder", "unreadable"):
                copy = self.top / "inputs"
                shutil.rmtree(copy, ignore_errors=True)
                shutil.copytree(path.parent, copy)
                target = copy / path.name
                target.unlink()
                if kind == "a folder":
                    target.mkdir()
                elif kind == "unreadable":
                    target.symlink_to("/proc/self/mem")  # reading fails for everybody, root included
                command = [word.replace(str(path.parent), str(copy)) for word in verb.command(self.program, self.folder())]
                folder = pathlib.Path(command[-1]) if verb.out else self.folder()
                done = run(command)
                self.check_end(verb, f"{path.name} is {kind}", done, folder, allowed=(1, 2))
                if folder.exists():
                    self.find(verb, f"{path.name} is {kind}", "a folder is there")

    def refusing_folders(self, verb):
        if not verb.out:
            return
        blocked = self.top / "blocked"
        blocked.write_text("a file")
        for folder, why in ((pathlib.Path("/proc/railpem/out"), "the folder is read-only"), (blocked, "the folder is a file")):
            done = run(verb.command(self.program, folder))
            self.checks += 1
            if done.returncode != 2 or "cannot be written" not in done.stderr:
                self.find(verb, why, f"exit status {done.returncode}: {done.stderr.strip()[-200:]}")

    def all_of(self, verb):
        self.undisturbed(verb)
        for fault in (self.refusing_folders, self.refusing_inputs, self.full_disk, self.small_disk, self.earlier_results_stay, self.killed, self.allocations):
            fault(verb)


def main():
    thorough = "--thorough" in sys.argv
    program, preload, *names = [word for word in sys.argv[1:] if word != "--thorough"]
    random.seed(2026)
    with tempfile.TemporaryDirectory() as temporary:
        top = pathlib.Path(temporary)
        faults = Faults(program, preload, top, thorough)
        for verb in verbs(program, top):
            if names and verb.name not in names:
                continue
            before = faults.checks
            begin = time.monotonic()
            faults.all_of(verb)
            print(f"{verb.name}: {faults.checks - before} checks, {time.monotonic() - begin:.0f} s", flush=True)
        print("\n".join(faults.findings) or f"{faults.checks} checks: nothing lost, nothing half-written")
    return 1 if faults.findings else 0


if __name__ == "__main__":
    sys.exit(main())
