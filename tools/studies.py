"""What the programs that rebuild papers share: where a result comes from, Markdown, and files that are whole or not there."""
import datetime
import json
import os
import pathlib
import platform
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]


def run(command, **options):
    """Runs a program to its end; ends this one where that fails."""
    done = subprocess.run([str(word) for word in command], check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}")
    return done


def require_program(path):
    if not os.access(path, os.X_OK):
        sys.exit(f"there is no program {path}: build it, or name it on the command line")


def commit():
    done = subprocess.run(["git", "-C", str(ROOT), "log", "-1", "--format=%h"], capture_output=True, text=True, check=False)
    changed = subprocess.run(["git", "-C", str(ROOT), "status", "--porcelain"], capture_output=True, text=True, check=False).stdout
    return (done.stdout.strip() or "unknown") + (" with changes" if changed.strip() else "")


def processor():
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def origin():
    """Date, commit and machine, as the first words of a report."""
    return f"{datetime.date.today()}, commit {commit()}, {processor()}, {os.cpu_count()} threads"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join(["---"] * len(head)) + " |"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def cell(value, pattern):
    return pattern.format(value) if isinstance(value, (int, float)) else "–"


def read_json(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def write(path, lines):
    temporary = path.with_suffix(path.suffix + ".part")
    temporary.write_text("\n".join(lines), encoding="utf-8")
    temporary.rename(path)
    print(f"wrote {path}")
