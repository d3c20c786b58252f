#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_structure.py ROOT: include direction, libraries behind their walls, file length, licence lines, own paths only.

Prints file:line and the rule for each offence; exit status 1 when there is one.
"""
import re
import subprocess
import sys
from pathlib import Path

STAGES = ["input", "tracking", "eye", "tools", "physics", "topology", "observe", "render", "video"]
BELOW_STAGES = ["base", "math", "mesh", "energy", "flow", "net"]
# Which folders a kernel folder may include from.
MAY_INCLUDE = {name: BELOW_STAGES[: i + 1] for i, name in enumerate(BELOW_STAGES)}
MAY_INCLUDE.update({stage: BELOW_STAGES + [stage] for stage in STAGES})
MAY_INCLUDE["session"] = BELOW_STAGES + STAGES + ["session"]

# Likewise of bindings/: the command line and the station are two users of trials; the station knows nothing of the
# command line, which loads it.
BINDINGS = {"lua": ["lua"], "records": ["records"], "trial": ["lua", "trial"],
            "station": ["lua", "trial", "station"], "track": ["lua", "trial", "track"],
            "cli": ["lua", "records", "trial", "station", "track", "cli"]}

# A library may be included only where these prefixes say.
WALLS = {
    r"opencv2/": ["kernel/tracking/", "kernel/video/", "tests/"],
    r"png\.h": ["kernel/render/"],
    r"(epoxy/|EGL/|GL/)": ["kernel/render/", "bindings/station/window/", "bindings/theatre/",
                             "tests/bindings/station/window/"],
    r"(SDL\.h|SDL2/|imgui|backends/imgui)": ["bindings/station/window/", "bindings/theatre/",
                                             "tests/bindings/station/window/"],
    r"zmq": ["bindings/theatre/", "tests/bindings/theatre/"],
    r"(sys/socket\.h|netinet/|arpa/)": ["kernel/net/"],
    r"(lua\.h|lua\.hpp|lualib\.h|lauxlib\.h|luaconf\.h)": ["bindings/lua/", "tests/bindings/"],
    r"ceres/": ["kernel/tracking/"],
    r"(igtl|openigtlink)": ["kernel/net/", "tests/kernel/net/"],
    r"cholmod\.h": ["kernel/math/", "tests/bench/"],
    r"CLI/": ["bindings/cli/"],
    r"(soci/|sqlite3\.h)": ["bindings/records/"],
}
HARD_LINES = 600
FOREIGN_PATHS = re.compile(r"(/work/|\.\./shared|/root/)")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
SOURCES = {".cpp", ".hpp"}
NEEDS_LICENCE = {".cpp", ".hpp", ".lua", ".py", ".sh", ".cmake", ".vert", ".frag", ".comp", ".glsl"}
READ_AS_TEXT = NEEDS_LICENCE | {".md", ".txt", ".json"}


def project_files(root):
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard"],
                            capture_output=True, text=True, check=False)
    names = listed.stdout.splitlines() if listed.returncode == 0 else [
        str(p.relative_to(root)) for p in root.rglob("*") if p.is_file()]
    return [name for name in names if (root / name).is_file()]


def include_offences(name, line_number, line):
    match = INCLUDE.match(line)
    if not match:
        return
    target = match.group(2)
    for pattern, allowed in WALLS.items():
        if re.match(pattern, target) and not any(name.startswith(prefix) for prefix in allowed):
            yield f"{name}:{line_number}: includes {target}, allowed only in {', '.join(allowed)}"
    parts = name.split("/")
    if parts[0] not in ("kernel", "bindings") or match.group(1) != '"' or "/" not in target:
        return
    folder, other = parts[1], target.split("/")[0]
    if parts[0] == "bindings":
        if other in BINDINGS and folder in BINDINGS and other not in BINDINGS[folder]:
            yield f"{name}:{line_number}: {folder}/ includes {target}; it may include {', '.join(BINDINGS[folder])}"
    elif other in ("bindings", "tests", *BINDINGS):
        yield f"{name}:{line_number}: the kernel includes {target}"
    elif other in MAY_INCLUDE and other not in MAY_INCLUDE[folder]:
        yield f"{name}:{line_number}: {folder}/ includes {target}; it may include {', '.join(MAY_INCLUDE[folder])}"


def offences(root):
    for name in project_files(root):
        path = root / name
        if path.suffix not in READ_AS_TEXT:
            continue
        lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
        if path.suffix in NEEDS_LICENCE and not any("SPDX-License-Identifier" in line for line in lines[:3]):
            yield f"{name}:1: no SPDX-License-Identifier in the first three lines"
        if path.suffix in NEEDS_LICENCE and len(lines) > HARD_LINES:
            yield f"{name}:{len(lines)}: longer than {HARD_LINES} lines"
        for number, line in enumerate(lines, 1):
            if FOREIGN_PATHS.search(line) and not name.startswith("tests/architecture/"):
                yield f"{name}:{number}: names a path outside the repository"
            if path.suffix in SOURCES:
                yield from include_offences(name, number, line)


def main():
    found = list(offences(Path(sys.argv[1]).resolve()))
    for offence in found:
        print(offence)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
