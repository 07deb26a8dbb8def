#!/usr/bin/env python3
"""run_document.py BUILD DOCUMENT... runs the commands of documents as a reader would, as they are printed.

The folder that they run in looks like that of the sources: tools/ and apps/ are those of the sources, build/release is BUILD,
and the apps are in the PATH. Made-up files that a document names (model.obj, body.msh) are small generated ones
(document_inputs.py); files that it shows, ```json blocks whose first line is // and a name, are written. Then all commands,
``` blocks without a language, run in one shell, which ends at the first command that fails. Lines of ```text blocks must be
among what they print, in this order. A block below a line <!-- not run: REASON --> is left out, and said to be. Commands within a line of text
are not allowed: nobody would run them."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import document_inputs

ROOT = document_inputs.ROOT
FENCE = re.compile(r"^(?:<!-- not run: (?P<reason>.*?) -->\n)?```(?P<language>\w*)\n(?P<content>.*?)^```$", re.DOTALL | re.MULTILINE)
LANGUAGES = {"", "text", "json", "cpp", "cmake"}


class Document:
    def __init__(self, path):
        text = pathlib.Path(path).read_text()
        self.name = os.path.relpath(path, ROOT)
        fences = list(FENCE.finditer(text))
        self.skipped = [fence for fence in fences if fence["reason"]]
        self.blocks = [fence for fence in fences if not fence["reason"]]
        self.faults = self.find_faults(text, fences)

    def of(self, language):
        return [fence["content"] for fence in self.blocks if fence["language"] == language]

    def find_faults(self, text, fences):
        """What would keep a command from being run without anybody noticing."""
        faults = []
        if len(re.findall(r"^\s*```", text, re.MULTILINE)) != 2 * len(fences):
            faults.append("a ``` that begins or ends no block at the left margin")
        if text.count("<!-- not run:") != len(self.skipped):
            faults.append("a 'not run' that stands above no block")
        faults += [f"language '{fence['language']}' is none of {sorted(LANGUAGES)}" for fence in fences
                   if fence["language"] not in LANGUAGES]
        faults += [f"a command within the text: {code}" for code in
                   re.findall(r"`([^`\n]+)`", FENCE.sub("", text)) if re.match(r"isostretch-[a-z]+ +[^-\s]", code)]
        return faults


def commands_in(content):
    """Lines of a block, those that go on behind a backslash as one."""
    return [line for line in content.replace("\\\n", " ").splitlines() if line.strip() and not line.startswith("#")]


def prepare(folder, build, document):
    commands = "".join(document.of(""))
    shown = "".join(document.of("json"))
    (folder / "build").mkdir()
    (folder / "build" / "release").symlink_to(build)
    for name in ("tools", "apps"):
        (folder / name).symlink_to(ROOT / name)
    document_inputs.write(folder, [name for name in document_inputs.FILES
                                   if re.search(rf"(?<![\w/.]){re.escape(name)}\b", commands + shown)])
    for content in document.of("json"):
        head, rest = content.split("\n", 1)
        if head.startswith("// "):
            (folder / head.removeprefix("// ")).write_text(rest)


def environment(build):
    folders = [str(path) for path in sorted(pathlib.Path(build, "apps").glob("isostretch-*"))]
    return dict(os.environ, PATH=os.pathsep.join(folders + [os.environ["PATH"]]), OMP_WAIT_POLICY="passive")


def run(document, build):
    commands = "set -eux\n" + "".join(document.of(""))
    with tempfile.TemporaryDirectory() as folder:
        prepare(pathlib.Path(folder), build, document)
        return subprocess.run(["bash", "-c", commands], cwd=folder, env=environment(build), text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def missing_lines(document, output):
    """Lines of ```text blocks that are not printed, or not in this order."""
    printed, missing = output.splitlines(), []
    for line in filter(None, "".join(document.of("text")).splitlines()):
        if line in printed:
            printed = printed[printed.index(line) + 1:]
        else:
            missing.append(line)
    return missing


def check(path, build):
    """Whether all commands of a document run."""
    document = Document(path)
    begin = time.monotonic()
    done = run(document, build)
    print(done.stdout)
    missing = missing_lines(document, done.stdout)
    for fault in document.faults + [f"not printed: {line}" for line in missing]:
        print(f"{document.name}: {fault}")
    skipped = [(command, fence["reason"]) for fence in document.skipped if not fence["language"]
               for command in commands_in(fence["content"])]
    for command, reason in skipped:
        print(f"skipped ({reason}): {command.strip()}")
    count = len([command for content in document.of("") for command in commands_in(content)])
    good = done.returncode == 0 and not missing and not document.faults
    print(f"{document.name}: {count} command(s), {len(skipped)} skipped, {time.monotonic() - begin:.1f} s: "
          f"{'good' if good else f'FAILED (exit code {done.returncode})'}", flush=True)
    return good


def main(build, *documents):
    return 0 if all([check(path, pathlib.Path(build).resolve()) for path in documents]) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
