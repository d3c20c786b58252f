#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The structure check names each kind of offence, and is silent on a clean tree."""
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from check_structure import HARD_LINES, offences  # noqa: E402

SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
CASES = [
    ("kernel/physics/a.cpp", SPDX + '#include "flow/solid.hpp"\n#include "physics/b.hpp"\n', None),
    ("kernel/physics/a.cpp", SPDX + '#include "render/renderer.hpp"\n', "physics/ includes render/renderer.hpp"),
    ("kernel/math/a.cpp", SPDX + '#include "mesh/tet_mesh.hpp"\n', "math/ includes mesh/tet_mesh.hpp"),
    ("kernel/eye/a.cpp", SPDX + '#include "session/session.hpp"\n', "eye/ includes session/session.hpp"),
    ("kernel/eye/a.cpp", SPDX + "#include <lua.h>\n", "includes lua.h"),
    ("kernel/eye/a.cpp", SPDX + '#include "trial/attempt.hpp"\n', "the kernel includes trial/attempt.hpp"),
    ("bindings/trial/a.cpp", SPDX + '#include "cli/command.hpp"\n', "trial/ includes cli/command.hpp"),
    ("bindings/cli/a.cpp", SPDX + '#include "trial/attempt.hpp"\n#include "lua/script.hpp"\n', None),
    ("bindings/cli/a.cpp", SPDX + "#include <opencv2/core.hpp>\n", "includes opencv2/core.hpp"),
    ("bindings/station/a.cpp", SPDX + "#include <SDL.h>\n", "includes SDL.h"),
    ("bindings/station/window/a.cpp", SPDX + "#include <SDL.h>\n#include <imgui.h>\n", None),
    ("bindings/station/a.cpp", SPDX + '#include "cli/command.hpp"\n', "station/ includes cli/command.hpp"),
    ("kernel/eye/a.cpp", "int x;\n", "no SPDX"),
    ("kernel/eye/a.cpp", SPDX + "int x;\n" * HARD_LINES, "longer than"),
    ("docs/a.md", "see /wo" + "rk/main\n", "names a path"),
]


def main():
    for name, text, expected in CASES:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            path.parent.mkdir(parents=True)
            path.write_text(text, encoding="utf-8")
            found = list(offences(Path(folder)))
        if expected is None:
            assert not found, found
        else:
            assert len(found) == 1 and expected in found[0] and name in found[0], (expected, found)
    return 0


if __name__ == "__main__":
    sys.exit(main())
