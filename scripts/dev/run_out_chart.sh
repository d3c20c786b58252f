#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures how often a capsulorhexis runs out, over fill of the chamber, age and direction of pull, and how often
# one is led back, and draws it: docs/data/run_out.csv, docs/data/run_out_rescue.csv and docs/pictures/run_out.svg. Needs a
# Release build (./demo.sh makes one) and the Debian package gnuplot-nox. It takes about 45 minutes of one core.
#   usage: scripts/dev/run_out_chart.sh [--draw]     --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
data=docs/data/run_out.csv
rescue=docs/data/run_out_rescue.csv
picture=docs/pictures/run_out.svg

need_gnuplot
if [ "${1:-}" != --draw ]; then
    fields=(name fill vitreous_mmhg age inwards_deg attempts ran_out stuck share share_low share_high round_at_out_deg
        end_radius_mm peak_mn cpu_s_per_attempt)
    bench_to_csv run_out "$data" "${fields[@]}"
    part=$(mktemp)
    trap 'rm -f "$part"' EXIT
    for case in run_out_direction run_out_age; do
        bench_to_csv "$case" "$part" "${fields[@]}"
        tail -n +2 "$part" >>"$data"
    done
    bench_to_csv run_out_rescue "$rescue" name inwards_deg fill attempts rescued reached_edge pulls share_low share_high fisher_p
fi

share_of() {  # PATTERN COLUMN COLOUR TITLE
    printf '%s' "\"< grep '$1' $data\" using $2:(100*\$9):(100*\$10):(100*\$11) with yerrorlines lc rgb '$3' pt 7 ps 0.7 lw 2 title '$4'"
}

gnuplot <<END
set terminal svg size 1000,760 font "sans,12" background "white"
set output "$picture"
set datafile separator ","
set multiplot layout 2,2
set grid xtics ytics lc rgb "#dddddd"
set yrange [0:100]
set ylabel "run out [%]; bars: 95 %"
set title "40 hands, vitreous at 20 mmHg, 68 years"
set xlabel "fill of the chamber"
set xrange [0.1:1.1]
unset key
plot $(share_of '^run_out/fill' 2 '#c03030' '')
set key top right
set title "hands that all pull one way, by fill"
set xlabel "pull, inwards from the tangent [degrees]"
set xrange [-15:45]
plot $(share_of '^run_out/direction.*/fill 0.2,' 5 '#c03030' '0.2'), \\
     $(share_of '^run_out/direction.*/fill 0.6,' 5 '#e08214' '0.6'), \\
     $(share_of '^run_out/direction.*/fill 1,' 5 '#1b9e5a' '1.0')
set title "beginners, by fill"
set xlabel "age [years]"
set xrange [20:95]
plot $(share_of '^run_out/age.*/fill 0.2,' 4 '#c03030' '0.2'), \\
     $(share_of '^run_out/age.*/fill 1,' 4 '#1b9e5a' '1.0')
set title "led back after it ran out at fill 0.2"
set ylabel "rescued [%]; bars: 95 %"
set xlabel "pull, inwards from the tangent [degrees]"
set xrange [20:100]
set key bottom right
plot "< grep '/fill 1,' $rescue" using 2:(100*\$5/\$4):(100*\$8):(100*\$9) with yerrorlines lc rgb '#1b9e5a' pt 7 ps 0.7 lw 2 title 'refilled', \\
     "< grep '/fill 0.2,' $rescue" using 2:(100*\$5/\$4):(100*\$8):(100*\$9) with yerrorlines lc rgb '#c03030' pt 7 ps 0.7 lw 2 title 'as it is'
unset multiplot
END
say "$data, $rescue, $picture"
