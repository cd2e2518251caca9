"""Interrupt commands that write files: python tests/faults/campaign_faults.py --seed N --count N.

Each trial runs `mesh` or `dissect` with all its results in a folder, where some of the names hold older files, and
disturbs it: SIGKILL or SIGINT at a random moment, or just when a file appears in the folder; a limit on the size of
files; a disk of some kilobytes (where a memory disk can be mounted). Afterwards each name must hold the old bytes, or
all of the new ones, those of a run in peace. Nothing else may be there; but SIGKILL may leave one file with a name as
`.exactmesh-0123456789abcdef.tmp`, which must not disturb the next run. SIGINT ends with status 130 or a finished run, a
full disk with status 2, and both with one line to read. Exit status 0 when all of this holds.
"""

import argparse
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from exactmesh import cli
from exactmesh.commands import dissect, mesh

LEFT_OVER = re.compile(r"\.exactmesh-[0-9a-f]{16}\.tmp")
INPUTS = {
    "room.wkt": "POLYGON ((0 0, 40 0, 40 30, 0 30, 0 0), (3 3, 4 20, 20 21, 30 4, 3 3))",
    "a.wkt": "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))", "b.wkt": "POLYGON ((0 0, 4 0, 4 1, 0 1, 0 0))"}
IMPORTED = (dissect, mesh)
COMMANDS = {
    "mesh": (["mesh", "room.wkt", "-o", "m.json", "--report", "r.json", "--svg", "s.svg", "--pslg", "p.json",
              "--certificate", "c.json", "--quiet"], ("m.json", "r.json", "s.svg", "p.json", "c.json")),
    "dissect": (["dissect", "a.wkt", "b.wkt", "-o", "d.json", "--svg", "d.svg", "--cut-sheet", "d-sheet.svg",
                 "--quiet"], ("d.json", "d.svg", "d-sheet.svg"))}
OLD = b"an older file\n"


@dataclass(frozen=True)
class Peace:
    """What a command writes when nothing happens, and how long it takes."""

    files: Mapping[str, bytes]
    seconds: float


def start(folder: Path, words: Sequence[str], prepare: Callable[[], None] = lambda: None) -> int:
    """Run a command in a child of this process, which has imported what it needs; return its number."""
    child = os.fork()
    if child:
        return child
    status = 3
    try:
        os.chdir(folder)
        for number, name in ((1, "out"), (2, "err")):
            os.dup2(os.open(f"../{name}", os.O_WRONLY | os.O_CREAT | os.O_TRUNC), number)
        sys.stdout, sys.stderr = open(1, "w", closefd=False), open(2, "w", closefd=False)  # noqa: SIM115
        signal.signal(signal.SIGINT, signal.default_int_handler)
        prepare()
        status = cli.main(words)
        sys.stdout.flush()
        sys.stderr.flush()
    except KeyboardInterrupt:  # before or after the command
        status = 130
    finally:
        os._exit(status)


def ended(child: int) -> int:
    """Wait for a child; return its exit status, or minus the number of the signal that ended it."""
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


@contextmanager
def new_folder(where: Path, source: random.Random | None, names: Sequence[str]) -> Iterator[tuple[Path, set[str]]]:
    """Make a folder with the inputs and, at random, older files under some of the names; yield it and those names."""
    folder = where / "work"
    folder.mkdir()
    for name, text in INPUTS.items():
        (folder / name).write_text(text)
    older = {name for name in names if source and source.random() < 0.5}
    for name in older:
        (folder / name).write_bytes(OLD)
    try:
        yield folder, older
    finally:
        shutil.rmtree(folder)


def peace(where: Path, name: str) -> Peace:
    """Return what a command writes when nothing happens."""
    words, names = COMMANDS[name]
    with new_folder(where, None, names) as (folder, _):
        begin = time.perf_counter()
        status = ended(start(folder, words))
        seconds = time.perf_counter() - begin
        if status:
            raise RuntimeError(f"{name} ended with {status}: {(where / 'err').read_text()}")
        return Peace({name: (folder / name).read_bytes() for name in names}, seconds)


# --- what happens ---


def at_random(child: int, folder: Path, source: random.Random, seconds: float) -> None:
    """Wait for a random part of the time that the command takes, or a little more."""
    time.sleep(source.uniform(0, 1.1) * seconds)


def at_a_file(child: int, folder: Path, source: random.Random, seconds: float) -> None:
    """Wait until the folder has changed a few times, and a moment more."""
    seen, changes = set(os.listdir(folder)), source.randrange(1, 10)
    deadline = time.perf_counter() + 3 * seconds + 1
    while changes and time.perf_counter() < deadline and os.waitid(
            os.P_PID, child, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None:
        now = set(os.listdir(folder))
        changes -= now != seen
        seen = now
    time.sleep(source.choice((0, 0, 0.0002, 0.002)))


def with_signal(number: int) -> Callable[[Path, Sequence[str], random.Random, float], int]:
    """Return a disturbance that sends a signal."""
    def disturbed(folder: Path, words: Sequence[str], source: random.Random, seconds: float) -> int:
        child = start(folder, words)
        source.choice((at_random, at_a_file))(child, folder, source, seconds)
        with suppress(ProcessLookupError):
            os.kill(child, number)
        return ended(child)

    return disturbed


def with_small_files(folder: Path, words: Sequence[str], source: random.Random, seconds: float) -> int:
    """Let no file become longer than a few bytes or kilobytes."""
    size = source.choice((0, 1, source.randrange(1000), source.randrange(20_000)))
    return ended(start(folder, words, lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))))


def with_small_disk(folder: Path, words: Sequence[str], source: random.Random, seconds: float) -> int:
    """Run on a disk of a few kilobytes; the folder holds afterwards what is on it."""
    there = folder.parent / "disk"
    there.mkdir()
    size = source.randrange(11, 26) * 4096  # room for what is there already
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "none", str(there)], check=True, capture_output=True)
    try:
        inner = there / "work"
        shutil.copytree(folder, inner)
        # The messages go to the same disk, where no room may be left for them.
        status = ended(start(inner, words))
        shutil.copy(there / "err", folder.parent / "err")
        shutil.rmtree(folder)
        shutil.copytree(inner, folder)
    finally:
        subprocess.run(["umount", str(there)], check=True, capture_output=True)
        there.rmdir()
    return status


def can_mount(where: Path) -> bool:
    """Whether memory disks can be mounted here."""
    there = where / "trial"
    there.mkdir()
    try:
        words = ["mount", "-t", "tmpfs", "-o", "size=4096", "none", str(there)]
        mounted = subprocess.run(words, capture_output=True, check=False).returncode == 0
        if mounted:
            subprocess.run(["umount", str(there)], check=True, capture_output=True)
    except OSError:
        mounted = False
    there.rmdir()
    return mounted


FAULTS = {"SIGKILL": with_signal(signal.SIGKILL), "SIGINT": with_signal(signal.SIGINT),
          "small files": with_small_files, "small disk": with_small_disk}


# --- the campaign ---


def wrong(fault: str, status: int, error: str, folder: Path, older: set[str], expected: Mapping[str, bytes]
          ) -> list[str]:
    """Return what is wrong with what is left."""
    found = []
    names = set(os.listdir(folder)) - set(INPUTS)
    for name, data in expected.items():
        left = (folder / name).read_bytes() if name in names else None
        if left not in (data, OLD if name in older else None):
            found.append(f"{name} is neither old nor new: {left!r:.80}")
    more = names - set(expected)
    if fault == "SIGKILL":
        more = {name for name in more if not LEFT_OVER.fullmatch(name)} | (more if len(more) > 1 else set())
    if more:
        found.append(f"also there: {sorted(more)}")
    done = status == 0 and all((folder / name).is_file() and (folder / name).read_bytes() == data
                               for name, data in expected.items())
    right = {"SIGKILL": status == -signal.SIGKILL, "SIGINT": status == 130}.get(fault, status == 2)
    if not (done or right):
        found.append(f"status {status}")
    if fault != "SIGKILL" and ("Traceback" in error or error.count("\n") > 1):
        found.append(f"not a line: {error!r:.300}")
    return found


def run(seed: int, count: int, faults: Sequence[str]) -> tuple[list[str], str]:
    """Return what was found wrong, and a table."""
    source = random.Random(seed)
    problems: list[str] = []
    table: Counter[tuple[str, str, str]] = Counter()
    with tempfile.TemporaryDirectory(prefix="exactmesh-faults-") as name:
        where = Path(name)
        usable = [fault for fault in faults if fault != "small disk" or can_mount(where)]
        in_peace = {command: peace(where, command) for command in COMMANDS}
        for number in range(count):
            fault, command = usable[number % len(usable)], source.choice(list(COMMANDS))
            words, names = COMMANDS[command]
            expected = in_peace[command].files
            with new_folder(where, source, names) as (folder, older):
                status = FAULTS[fault](folder, words, source, in_peace[command].seconds)
                found = wrong(fault, status, (where / "err").read_text(errors="replace"), folder, older, expected)
                written = sum((folder / name).is_file() and (folder / name).read_bytes() == expected[name]
                              for name in names)
                left = any(LEFT_OVER.fullmatch(name) for name in os.listdir(folder))
                if left and ended(start(folder, words)) != 0:
                    found.append("what was left over disturbs the next run")
            outcome = "all" if written == len(names) else "some" if written else "none"
            table[fault, outcome, "left over" if left else ""] += 1
            problems += [f"{number}, {command}, {fault}: {text}" for text in found]
    rows = [f"{number:7}  {fault:12}  {outcome:5} {left}" for (fault, outcome, left), number in sorted(table.items())]
    lines = [" trials  fault         new files", *map(str.rstrip, rows)]
    if len(usable) < len(faults):
        lines.append("small disk: left out, none can be mounted here")
    lines.append(f"{count} trials, seed {seed}: {len(problems)} problems")
    return problems, "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=400)
    args = parser.parse_args()
    begin = time.perf_counter()
    problems, table = run(args.seed, args.count, list(FAULTS))
    print("\n".join([*problems[:20], table, f"{time.perf_counter() - begin:.0f} s"]))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
