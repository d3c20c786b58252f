#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the triangles of the foldable lens, shaded by thickness: docs/pictures/implant_mesh.svg. Needs a Release build
# (./demo.sh makes one) and the Debian package gnuplot-nox.
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
picture=docs/pictures/implant_mesh.svg

need_gnuplot
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
build/release/bindings/cli/rhexis bench implant_mesh --json |
    python3 -c '
import json, sys
row = json.load(sys.stdin)["cases"][0]
for corners, thickness in zip(row["triangles"], row["thickness"]):
    for x, y in corners + corners[:1]:
        print(f"{x:.4f} {y:.4f} {thickness:.3f}")
    print("\n")
' >"$rows"

gnuplot <<END
set terminal svg size 520,760 font "sans,12" background "white"
set output "$picture"
set size ratio -1
set xlabel "mm"
set palette defined (0.25 "#dfeaf5", 0.7 "#3f77b5")
set cbrange [0.25:0.7]
set cblabel "thickness [mm]"
set style fill solid 1.0
plot "$rows" using 1:2:3 with filledcurves closed lc palette notitle, \
     "$rows" using 1:2 with lines lc rgb "#333333" lw 0.5 notitle
END
say "$picture"
