"""The library folders as the checks in this folder see them: rules, CMake arguments, files and their #include lines."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Rule:
    def __init__(self, components, headers):
        self.components = components
        self.headers = headers


def read_rules(text):
    rules = {}
    for line in text.splitlines():
        line = line.split("#")[0].strip()
        if not line:
            continue
        name, rest = line.split(":", 1)
        components, _, headers = rest.partition("|")
        rules[name.strip()] = Rule(components.split(), headers.split())
    return rules


def rules():
    return read_rules((ROOT / "cmake" / "dependency_rules.txt").read_text())


def closure(rules, names):
    """The libraries named and everything below them."""
    found, todo = set(), list(names)
    while todo:
        name = todo.pop()
        if name not in found:
            found.add(name)
            todo += rules[name].components if name in rules else []
    return found


def folders(root=ROOT):
    return {path.parent.name: path.parent for path in sorted((root / "libs").glob("*/CMakeLists.txt"))}


def cmake_argument(cmake_text, keyword):
    """The words after `keyword` in the call of isostretch_add_library, up to the next keyword."""
    text = re.sub(r'"(?:\\.|[^"\\])*"|#[^\n]*', lambda m: "" if m.group(0)[0] == "#" else '"quoted"', cmake_text)
    call = re.search(r"isostretch_add_library\(([^)]*)\)", text)
    if not call:
        return []
    words, taking = [], False
    for word in call.group(1).split():
        if re.fullmatch(r"[A-Z_]+", word):
            taking = word == keyword
        elif taking:
            words.append(word)
    return words


def sources(folder, *parts):
    """C++ files under the parts of a library folder (include, src, tests, bench)."""
    return [path for part in parts for path in sorted((folder / part).rglob("*"))
            if path.suffix in (".hpp", ".cpp", ".h", ".inc")]


def without_comments_and_strings(text):
    """Comments and string contents blanked, line numbers kept."""
    def blank(match):
        token = match.group(0)
        if token.startswith('"'):
            return '""'
        return "\n" * token.count("\n") if token.startswith("/") else "' '"
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])\'', blank, text,
                  flags=re.DOTALL)


def includes(text):
    """(line number, header, angled) of every #include, those in comments left out."""
    kept = re.sub(r"/\*.*?\*/", lambda m: "\n" * m.group(0).count("\n"), text, flags=re.DOTALL)
    found = []
    for number, line in enumerate(kept.splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if match:
            found.append((number, match.group(2), match.group(1) == "<"))
    return found
