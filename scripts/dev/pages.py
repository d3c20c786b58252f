# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of pages in docs/ that commands write, between two lines that mark them."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def write_between(page, begin, end, text):
    """Puts text between the lines begin and end of a page; ends the program in one line when they are not there."""
    whole = page.read_text(encoding="utf-8")
    if begin not in whole or end not in whole:
        sys.exit(f"rhexis: {page.relative_to(ROOT)} has lost the lines between which its table stands")
    before, rest = whole.split(begin, 1)
    after = rest.split(end, 1)[1]
    page.write_text(before + begin + "\n" + text + "\n" + end + after, encoding="utf-8")
