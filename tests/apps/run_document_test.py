#!/usr/bin/env python3
"""What run_document.py finds wrong with documents, and what it takes."""
import pathlib
import subprocess
import sys
import tempfile

RUNNER = pathlib.Path(__file__).with_name("run_document.py")
GOOD = "```\necho one\necho two\n```\n\n```text\none\n```\n\n```text\ntwo\n```\n"
# A document, and what has to be said of it; nothing where it is good.
CASES = [
    (GOOD, ""),
    ("no commands at all\n", ""),
    ("```json\n// file.json\n{}\n```\n\n```\ncat file.json\n```\n", ""),
    ("```\nhead -c 4 body.msh model.obj build/demo/bunny.obj\ntest -x build/release -a -d tools -a -d apps\n```\n", ""),
    ("<!-- not run: takes hours -->\n```\nfalse\n```\n", ""),
    ("```\nfalse || echo \"exit code $?\"\n```\n\n```text\nexit code 1\n```\n", ""),
    ("```\necho on its way\nfalse\necho never\n```\n", "FAILED (exit code 1)"),
    ("```\necho $unset_variable\n```\n", "FAILED (exit code 1)"),
    ("```\ncat nobody_makes_this.obj\n```\n", "FAILED (exit code 1)"),
    (GOOD.replace("text\none", "text\nthree"), "not printed: three"),
    (GOOD.replace("text\none", "text\ntwo").replace("text\ntwo\n```\n\n```text\ntwo", "text\ntwo\n```\n\n```text\none"), "not printed: one"),
    ("- a list\n\n  ```\n  false\n  ```\n", "begins or ends no block"),
    ("```\necho one\n", "begins or ends no block"),
    ("```bash\nfalse\n```\n", "language 'bash' is none of"),
    ("<!-- not run: too far away -->\n\n```\necho one\n```\n", "stands above no block"),
    ("Call `isostretch-deform body.msh --out out` then.\n", "a command within the text"),
]


def judge(folder, text):
    path = pathlib.Path(folder) / "document.md"
    path.write_text(text)
    run = subprocess.run([sys.executable, RUNNER, folder, path], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return run.returncode, run.stdout


def main():
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for text, complaint in CASES:
            code, output = judge(folder, text)
            if (code != 0) != bool(complaint) or complaint not in output:
                wrong += 1
                print(f"expected {complaint or 'no complaint'} of:\n{text}\nbut this ended with {code}:\n{output}")
        skipped = judge(folder, CASES[4][0])[1]
        if "skipped (takes hours): false" not in skipped or "1 skipped" not in skipped:
            wrong += 1
            print(f"a skipped command is not named:\n{skipped}")
    print(f"{len(CASES)} documents judged, {wrong} of them wrongly")
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
