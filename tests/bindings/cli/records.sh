#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Attempts of trainees: stored, listed, compared, exported, rated, deleted; and stores that are no good.
set -u
. "$(dirname "$0")/expect.sh"
export RHEXIS_RECORDS=$work/store/records.db LC_ALL=C
small=(--no-pictures --set patient.tetrahedra=500)
attempt=("$rhexis" run groove "${small[@]}" --limit 1)

# sql STATEMENT: on the store, and prints what it gives.
sql() {
    python3 - "$RHEXIS_RECORDS" "$1" <<'P'
import sqlite3, sys
store = sqlite3.connect(sys.argv[1])
for row in store.execute(sys.argv[2]):
    print(*row)
store.commit()
P
}
count() { sql "SELECT count(*) FROM $1"; }

# Nothing is stored without a trainee; names are pseudonyms.
expect 0 "" "${attempt[@]}" --out "$work/plain"
[ ! -e "$work/store" ] && [ ! -e "$work/plain/attempt.json" ] || fail "an attempt of nobody was stored"
expect 2 "there is no record store" "$rhexis" records list
expect 2 "neither HOME nor XDG_DATA_HOME is set" env -u HOME -u XDG_DATA_HOME -u RHEXIS_RECORDS "$rhexis" records list
expect 2 "e-mail" "${attempt[@]}" --out "$work/a" --trainee jo@clinic.org
expect 2 "is no pseudonym" "${attempt[@]}" --out "$work/a" --trainee "Jo Smith"
expect 2 "--trainee PSEUDONYM" "${attempt[@]}" --out "$work/a" --cohort 2026
expect 2 "--records is for attempts of a trainee" "${attempt[@]}" --out "$work/a" --records "$work/store/records.db"
expect 2 "there is no surgeon" "${attempt[@]}" --out "$work/a" --trainee P07 --surgeon nobody
[ ! -e "$work/a" ] && [ ! -e "$work/store" ] || fail "something is left of attempts that never began"

expect 2 "records: there is no command lst (did you mean list?)" "$rhexis" records lst
expect 2 "there is no option --trainer (did you mean --trainee?)" "$rhexis" records list --trainer P07
expect 2 "records show" "$rhexis" records show --json

# Stored attempts, and what the report then compares with.
for seed in 1 2 3; do
    expect 0 "" "${attempt[@]}" --seed $seed --out "$work/p$seed" --trainee P07 --cohort 2026 --arm simulator
done
expect 0 "" "${attempt[@]}" --seed 4 --out "$work/q1" --trainee P08 --cohort 2026
expect 0 "" "${attempt[@]}" --seed 5 --out "$work/q2" --trainee P09 --cohort 2026
expect 0 "" "${attempt[@]}" --seed 6 --out "$work/p4" --trainee P07
[ "$(count attempts)" = 6 ] && [ "$(count items)" -gt 30 ] && [ "$(count measures)" -gt 60 ] || fail "not all is stored"
[ "$(sql "SELECT cohort, arm FROM attempts WHERE trainee='P07' ORDER BY begun DESC LIMIT 1")" = "2026 simulator" ] ||
    fail "the cohort was forgotten"
python3 - "$work/p4/report.json" <<'P' || fail "the report lacks what to compare with"
import json, sys
report = json.load(open(sys.argv[1]))
assert len(report["history"]) == 3 and report["history"][0]["items"], report.get("history")
assert "cohort" not in report, "what others broke off is no measure"
P
grep -q "Compared with earlier attempts" "$work/p4/report.html" || fail "the page does not compare"

# A cohort is what others completed; in a store of its own.
cohort=("$rhexis" run viscoelastic_removal --surgeon d --no-pictures --cohort 2026 --records "$work/cohort.db")
for trainee in P08 P09 P07 P07; do
    seed=$((seed + 1))
    expect 0 "" "${cohort[@]}" --seed $seed --out "$work/cohort_$seed" --trainee $trainee
done
python3 - "$work/cohort_$seed/report.json" <<'P' || fail "the report lacks a cohort"
import json, sys
report = json.load(open(sys.argv[1]))
assert len(report["history"]) == 1 and report["history"][0]["completed"] and report["pass"] > 0, report.get("history")
assert report["cohort"]["group"] == "2026" and report["cohort"]["n"] == 2, report.get("cohort")
P
grep -q "Compared with earlier attempts and with others" "$work/cohort_$seed/report.html" || fail "the page lacks the cohort"
! grep -q '"history"' "$work/q1/report.json" || fail "a first attempt has a history"

# Lists, curves, gates, tables.
expect 0 "" "$rhexis" records list --trainee P07
says "4 attempts"
id=$(sql "SELECT attempt FROM attempts WHERE folder LIKE '%/p4'")
expect 0 "" "$rhexis" records show "${id:0:8}"
says "$work/p4"
expect 0 "" "$rhexis" records show "$id" --json
says '"recording_sha256": "'"$(sha256sum "$work/p4/recording.rhx" | cut -d' ' -f1)"
expect 2 "there is no attempt" "$rhexis" records show zzzz
expect 0 "" "$rhexis" records trainees
says "P08"
expect 0 "" "$rhexis" records gates
says "closed: 0 of 2 in a row"
expect 0 "" "$rhexis" records curve P07 --html "$work/curve.html"
says "P07, groove: first"
grep -q "<circle" "$work/curve.html" || fail "no chart"
says "  not completed"
grep -q "UTC: [0-9]*[^0-9]*%, not completed</title>" "$work/curve.html" || fail "a hollow point does not say why"
expect 0 "" "$rhexis" records curve P07 --html "$work/curve.html" --language fr
grep -q "<h2>Sculpture d&#39;un sillon</h2>" "$work/curve.html" || fail "the exercise has not its French title"
sql "UPDATE attempts SET title = 'My own groove' WHERE trainee = 'P07'"
expect 0 "" "$rhexis" records curve P07 --html "$work/curve.html" --language fr
grep -q "<h2>My own groove</h2>" "$work/curve.html" || fail "another exercise of this name has its title"
for command in "curve P07" agreement; do
    expect 2 "--language requires --html" "$rhexis" records $command --language fr
    expect 2 "there are no texts in it" "$rhexis" records $command --html "$work/none.html" --language xx
    [ ! -s "$work/stdout" ] && [ ! -e "$work/none.html" ] || fail "a refused language printed something"
done
expect 2 "nothing scored is stored of P99" "$rhexis" records curve P99
expect 2 "0 to 1" "$rhexis" records gates --pass 7
echo '{"usual": {"pass": "expert"}}' >"$work/gates.json"
expect 2 'what is pass = "expert"?' "$rhexis" records gates --gates "$work/gates.json"
sql "UPDATE attempts SET completed = 1 WHERE trainee = 'P07'"
expect 0 "" "$rhexis" records gates --pass 0
says "open since attempt 2"
expect 0 "" "$rhexis" records export --out "$work/csv"
[ "$(wc -l <"$work/csv/attempts.csv")" = 7 ] || fail "attempts.csv has not one line per attempt"
python3 - "$work/csv" <<'P' || fail "the tables do not fit each other"
import csv, sys
read = lambda name: list(csv.DictReader(open(f"{sys.argv[1]}/{name}.csv", encoding="utf-8", newline="")))
attempts = {row["attempt"] for row in read("attempts")}
for name in ("items", "measures", "events", "ratings"):
    assert all(row["attempt"] in attempts for row in read(name)), name
assert {row["duration_s"] for row in read("attempts")} == {"1"}
P
expect 2 "cannot make this folder" "$rhexis" records export --out /proc/nowhere
cp "$work/csv/items.csv" "$work/items.csv"
expect 2 "no attempt is stored of the trainee P99" "$rhexis" records export --out "$work/csv" --trainee P99
cmp -s "$work/items.csv" "$work/csv/items.csv" || fail "an export of nothing has written over a table"
expect 2 "did you mean groove?" "$rhexis" records list --exercise grove

# Who began in the middle has not passed; a store of the schema before kept no such moment.
sql "UPDATE attempts SET begun_at = 'half_way' WHERE trainee = 'P07'"
expect 0 "" "$rhexis" records gates P07 --pass 0
says "closed: 0 of 2 in a row"
expect 0 "" "$rhexis" records list --trainee P07
says "completed, begun at half_way"
sql "UPDATE attempts SET begun_at = '', aids = 'rewound guided' WHERE trainee = 'P07'"
expect 0 "" "$rhexis" records gates P07 --pass 0
says "closed: 0 of 2 in a row"
expect 0 "" "$rhexis" records list --trainee P07
says "with aids: rewound guided"
sql "UPDATE attempts SET begun_at = '', aids = ''"
# older VERSION COLUMN...: a store of that version, which had none of these columns.
older() {
    cp "$RHEXIS_RECORDS" "$work/older.db"
    python3 -c "import sqlite3, sys
sql = sqlite3.connect(sys.argv[1])
for column in sys.argv[3:]:
    sql.execute('ALTER TABLE attempts DROP COLUMN ' + column)
sql.execute('PRAGMA user_version = ' + sys.argv[2])
sql.commit()" "$work/older.db" "$@"
    expect 0 "" "$rhexis" records gates P07 --pass 0 --records "$work/older.db"
    says "open since attempt 2"
    [ "$(python3 -c "import sqlite3, sys; print(*sqlite3.connect(sys.argv[1]).execute('PRAGMA user_version').fetchone())" \
        "$work/older.db")" = 3 ] || fail "a store of version $1 was not brought up to date"
}
older 1 begun_at input aids
older 2 input aids

# An attempt of a trainee is not written over.
sum=$(sha256sum "$work/p4/recording.rhx")
expect 2 "lies in this folder already" "${attempt[@]}" --out "$work/p4" --trainee P08
expect 2 "lies in this folder already" "${attempt[@]}" --out "$work/p4"
[ "$(sha256sum "$work/p4/recording.rhx")" = "$sum" ] || fail "an attempt was written over"

# A killed process: what was done is kept, and shown as interrupted.
"$rhexis" run groove "${small[@]}" --limit 600 --set patient.tetrahedra=3000 --out "$work/killed" --trainee P07 \
    >"$work/killed.txt" 2>&1 &
victim=$!
for _ in $(seq 100); do
    [ -s "$work/killed/recording.rhx.part" ] && break
    sleep 0.1
done
sleep 2
expect 0 "" "$rhexis" records list --trainee P07
says "running"
kill -KILL $victim
now=$(date +%s%N)
wait $victim 2>/dev/null
age_ms=$(((now - $(date -r "$work/killed/recording.rhx.part" +%s%N)) / 1000000))
[ "$age_ms" -lt 1500 ] || fail "the recording ends $age_ms ms before the process was killed"
expect 0 "" "$rhexis" records list --trainee P07
says "interrupted"
says "$work/killed"
expect 0 "cut short" "$rhexis" replay "$work/killed"
expect 2 "cut short before it came to its report" "$rhexis" report "$work/killed"
expect 2 "cut short before it came to its report" "$rhexis" records add "$work/killed"

# In a folder with the report of an earlier run it stays interrupted.
cp "$work/p1/report.json" "$work/killed/report.json"
expect 0 "" "$rhexis" records list --trainee P07
says "interrupted"
expect 2 "of another attempt" "$rhexis" records add "$work/killed"
rm "$work/killed/report.json"

# Killed when the report stood and the store was not yet written: taken up by the next command.
sql "UPDATE attempts SET finished = 0, process = '$(hostname) another-boot pid:[1] 1 1' WHERE attempt = '$id'"
sql "DELETE FROM items WHERE attempt = '$id'"
expect 0 "" "$rhexis" records list
[ "$(sql "SELECT finished, (SELECT count(*) FROM items WHERE attempt = '$id') > 5 FROM attempts WHERE attempt = '$id'")" = "1 1" ] ||
    fail "a finished attempt was lost"

# A locked store: one line at the end, everything in the folder, stored later.
before=$(count attempts)
python3 - "$RHEXIS_RECORDS" <<'P' &
import sqlite3, sys, time
store = sqlite3.connect(sys.argv[1], isolation_level=None)
store.execute("BEGIN EXCLUSIVE")
time.sleep(60)
P
holder=$!
sleep 1
expect 2 "the attempt is not stored: $RHEXIS_RECORDS: locked by another program" "${attempt[@]}" --seed 7 \
    --out "$work/locked" --trainee P07
says "recording"
[ -s "$work/locked/report.json" ] && [ -s "$work/locked/report.html" ] && [ -s "$work/locked/recording.rhx" ] ||
    fail "the run of a locked store is lost"
expect 2 "locked" "$rhexis" records list
kill $holder
wait $holder 2>/dev/null
expect 0 "" "$rhexis" records add "$work/locked"
expect 0 "" "$rhexis" records add "$work/locked" # twice is once
[ "$(count attempts)" = $((before + 1)) ] || fail "an attempt was not added once"
expect 2 "--trainee PSEUDONYM" "$rhexis" records add "$work/plain"
expect 2 "--cohort requires --trainee" "$rhexis" records add "$work/plain" --cohort reference
expect 0 "" "$rhexis" records add "$work/plain" --trainee d-101 --cohort reference
expect 2 "--cohort 2027: the run was made with --cohort reference" "$rhexis" records add "$work/plain" \
    --trainee d-101 --cohort 2027
expect 2 "the run is of another trainee" "$rhexis" records add "$work/plain" --trainee P07
expect 2 "$work/nothing" "$rhexis" records add "$work/nothing" --trainee P07

# Stores that are no good: refused before anything runs, and left as they are.
refused() { # refused FILE TEXT
    local sum
    sum=$(sha256sum "$1" 2>/dev/null)
    expect 2 "$2" "${attempt[@]}" --out "$work/refused" --trainee P07 --records "$1"
    expect 2 "$2" "$rhexis" records list --records "$1"
    [ "$(sha256sum "$1" 2>/dev/null)" = "$sum" ] || fail "$1 was changed"
    [ ! -e "$work/refused/recording.rhx" ] || fail "an attempt ran that cannot be stored in $1"
}
head -c 20000 /dev/urandom >"$work/noise.db"
refused "$work/noise.db" "this is no record store, or it is damaged"
cp "$RHEXIS_RECORDS" "$work/cut.db"
truncate -s 12288 "$work/cut.db"
refused "$work/cut.db" "damaged"
cp "$RHEXIS_RECORDS" "$work/newer.db"
python3 -c "import sqlite3, sys; sqlite3.connect(sys.argv[1]).execute('PRAGMA user_version = 99')" "$work/newer.db"
refused "$work/newer.db" "schema 99, made by a newer rhexis"
python3 -c "import sqlite3, sys; sqlite3.connect(sys.argv[1]).execute('CREATE TABLE mine (x)')" "$work/other.db"
refused "$work/other.db" "another database"
refused "$work" "this is a folder"
expect 2 "the record store cannot be" "${attempt[@]}" --out "$work/refused" --trainee P07 --records /proc/records.db
if [ "$(id -u)" = 0 ] && command -v setpriv >/dev/null; then
    chmod a+rx "$work" "$work/store" && chmod 444 "$RHEXIS_RECORDS" && chmod 777 "$work"
    nobody=(setpriv --reuid 65534 --regid 65534 --clear-groups)
    if "${nobody[@]}" test -x "$rhexis"; then
        expect 0 "" "${nobody[@]}" "$rhexis" records list
        expect 2 "read-only" "${nobody[@]}" "${attempt[@]}" --out "$work/nobody" --trainee P07
    fi
    chmod 644 "$RHEXIS_RECORDS"
fi

# A disk that fills up while the end is stored: a limit on the size of files stands for it, below the size of this store.
cp "$RHEXIS_RECORDS" "$work/large.db"
python3 - "$work/large.db" <<'P'
import sqlite3, sys
store = sqlite3.connect(sys.argv[1])
store.execute("CREATE TABLE padding (x)")
store.execute("INSERT INTO padding VALUES (zeroblob(3000000))")
store.commit()
P
blocks=$(($(stat -c %s "$work/large.db") / 1024))
expect 2 "the attempt is not stored" bash -c 'limited "$@"' _ "$blocks" "${attempt[@]}" --out "$work/full" --trainee P07 \
    --records "$work/large.db"
[ -s "$work/full/report.html" ] && [ -s "$work/full/recording.rhx" ] || fail "the run of a full disk is lost"
expect 0 "" "$rhexis" records add "$work/full" --records "$work/large.db"

# A rater's folder tells nothing of whose the recordings are.
expect 0 "" "$rhexis" rate "$work"/p1 "$work"/q1 "$work"/q2 --no-video --out "$work/rater" --seed 3
[ "$(find "$work/rater" -type f | wc -l)" = 3 ] || fail "not a form for each recording"
! grep -rqiE "P0[789]|2026|simulator|expert|records\.db|$(basename "$work")" "$work/rater" ||
    fail "the forms are not blind"
grep -q 'name="G6"' "$work/rater/case_03/form.html" || fail "the form lacks items"
grep -q "<b>Sculpting a groove</b>" "$work/rater/case_03/form.html" || fail "the form does not name the exercise"
preset() { grep -qF "name=\"$2\" value=\"na\" checked" "$work/$1/case_01/form.html"; }
preset rater T1 || fail "an item that a groove does not judge is open"
! preset rater T9 || fail "an item that a groove judges is set to N/A"
cp -r "$work/p1" "$work/bare"
rm "$work/bare/report.json"
expect 0 "" "$rhexis" rate "$work/bare" --no-video --out "$work/rater_bare"
! preset rater_bare T1 || fail "an item is set to N/A where nothing is known of the exercise"
expect 0 "" "$rhexis" rate "$work/p1/recording.rhx" --no-video --out "$work/rater_french" --language fr
grep -q "<b>Sculpture d&#39;un sillon</b>" "$work/rater_french/case_01/form.html" || fail "no French title in the form"
preset rater_french T1 || fail "nothing is known of the run that a recording lies in"
expect 2 "not empty" "$rhexis" rate "$work/p1" --no-video --out "$work/rater"
order() { grep -rho 'data-case="[0-9a-f]*"' "$work/$1" --include form.html -r | tr '\n' ' '; }
expect 0 "" "$rhexis" rate "$work"/q2 "$work"/q1 "$work"/p1 --no-video --out "$work/rater_again" --seed 3
for i in 1 2 3; do
    cmp -s "$work/rater/case_0$i/form.html" "$work/rater_again/case_0$i/form.html" || fail "the order is not the seed's"
done
expect 2 "nowhere" "$rhexis" rate "$work/nowhere" --no-video --out "$work/rater_none"

# Answers, and how far judges agree.
answers() { # answers RUN RATER POINTS
    python3 - "$work/$1/recording.rhx" "$3" >"$work/$1-$2.json" <<'P'
import hashlib, json, sys
names = [f"T{i}" for i in range(1, 15)] + [f"G{i}" for i in range(1, 7)]
score = lambda i: None if i % 5 == 4 else max(1, min(5, int(sys.argv[2]) + i % 2))
print(json.dumps({"schema": 1, "form": "OSACSS", "case": hashlib.sha256(open(sys.argv[1], "rb").read()).hexdigest()[:12],
                  "comment": "", "items": {n: {"score": score(i), "comment": ""} for i, n in enumerate(names)}}))
P
}
expect 2 "nobody has rated anything yet" "$rhexis" records agreement
points=1
for run in p1 q1 q2; do
    points=$((points + 1))
    answers $run R1 "$points"
    answers $run R2 3
done
expect 0 "" "$rhexis" rate "$work"/p1 "$work"/q1 "$work"/q2 --answers "$work"/{p1,q1,q2}-R1.json --rater R1
expect 0 "" "$rhexis" records agreement
says "too few raters"
for option in "--out $work/elsewhere" "--seed 2" "--language fr" --no-video; do
    expect 2 "--answers excludes ${option%% *}" "$rhexis" rate "$work/p1" --answers "$work/p1-R1.json" --rater R1 \
        $option
done
expect 2 "--records requires --answers" "$rhexis" rate "$work/p1" --out "$work/elsewhere" --records "$RHEXIS_RECORDS"
[ ! -e "$work/elsewhere" ] || fail "a refused command made a folder"
expect 2 "already" "$rhexis" rate "$work/p1" --answers "$work/p1-R1.json" --rater R1
expect 0 "" "$rhexis" rate "$work/p1" --answers "$work/p1-R1.json" --rater R1 --replace
expect 2 "e-mail" "$rhexis" rate "$work/p1" --answers "$work/p1-R2.json" --rater r@x.org
expect 2 "another recording" "$rhexis" rate "$work/q1" --answers "$work/p1-R2.json" --rater R2
sed 's/"score": [0-9]/"score": 6/' "$work/p1-R2.json" >"$work/bad.json"
expect 2 "has the score 6" "$rhexis" rate "$work/p1" --answers "$work/bad.json" --rater R2
sed 's/"T2"/"T99"/' "$work/p1-R2.json" >"$work/bad.json"
expect 2 "there is no item T99" "$rhexis" rate "$work/p1" --answers "$work/bad.json" --rater R2
echo '{' >"$work/bad.json"
expect 2 "no file of answers" "$rhexis" rate "$work/p1" --answers "$work/bad.json" --rater R2
[ "$(count ratings)" = 3 ] || fail "answers that are no good were stored"
expect 0 "" "$rhexis" rate "$work"/p1 "$work"/q1 "$work"/q2 --answers "$work"/{p1,q1,q2}-R2.json --rater R2
expect 0 "" "$rhexis" records agreement --html "$work/agreement.html"
says "3 rated attempts, 2 raters"
says "total, R1 - R2"
grep -q "1.96 SD" "$work/agreement.html" || fail "no chart of differences"
grep -qF "3 rated attempts, 2 raters: R1, R2." "$work/agreement.html" || fail "the page does not say how many"
expect 0 "" "$rhexis" records agreement --html "$work/agreement.html" --language fr
! grep -q "Draping\|points per item\|have scored" "$work/agreement.html" || fail "English on a French page"

# Of an operation a rater sees every part, and rates the whole.
exercise look >/dev/null <<'L'
return exercise {
    title = "Look", tissues = { "viscoelastic" }, instruments = { "cannula" },
    steps = { step "look" { done = "step.time_s > 0.2" } }, scoring = osacss { "T3" },
}
L
echo 'return function(me) me.wait(1) end' >"$work/look/surgeon.lua"
exercise twice >/dev/null <<'L'
return operation {
    title = "Twice", parts = { part "one" { exercise = "../look" }, part "two" { exercise = "../look" } },
    scoring = osacss { "T3" },
}
L
expect 0 "" "$rhexis" run "$work/twice" --trainee P09 --no-pictures --out "$work/o1" --records "$work/whole.db"
expect 0 "" "$rhexis" rate "$work/o1" --out "$work/rater_whole"
for video in part_1/video.mp4 part_2/video.mp4; do
    [ -s "$work/rater_whole/case_01/$video" ] || fail "no $video for the rater"
    grep -q "src=\"$video\"" "$work/rater_whole/case_01/form.html" || fail "the form does not show $video"
done
code=$(grep -o 'data-case="[0-9a-f]*"' "$work/rater_whole/case_01/form.html" | grep -o '[0-9a-f]\{12\}')
sed "s/\"case\": \"[0-9a-f]*\"/\"case\": \"$code\"/" "$work/q1-R1.json" >"$work/o1-R1.json"
expect 0 "" "$rhexis" rate "$work/o1" --answers "$work/o1-R1.json" --rater R1 --records "$work/whole.db"
says "1 rating by R1"
expect 2 "another recording" "$rhexis" rate "$work/o1/parts/01_one" --answers "$work/o1-R1.json" --rater R1 \
    --records "$work/whole.db"

# Courses: what is open, what is next, and what is closed.
course() { # course CLOSED: two lessons
    printf '{ "title": "Two", "closed": "%s", "lessons": [ { "exercise": "viscoelastic_removal" }, { "exercise": "groove" } ] }\n' "$1" >"$work/two.json"
}
course notice
some=(--records "$work/cohort.db" --course "$work/two.json" --pass 0.05)
expect 0 "" "$rhexis" records next P07 "${some[@]}"
says "1  viscoelastic_removal      passed  since attempt 2"
says "2  groove                    open    not tried"
says "next: rhexis run groove --trainee P07 --course two"
expect 0 "" "$rhexis" records next P08 "${some[@]}"
says "viscoelastic_removal      open    1 attempt, 1 of 2 passes in a row"
says "groove                    closed  until viscoelastic_removal is passed"
expect 0 "" "$rhexis" records next NEW "${some[@]}"
says "next: rhexis run viscoelastic_removal --trainee NEW"
expect 0 "" "$rhexis" records course "$work/two.json" --records "$work/cohort.db" --html "$work/course.html" --language fr
says "P07"
grep -q "Retrait\|visco" "$work/course.html" || fail "the page does not name the lessons"
! grep -q "passes in a row\|in a row" "$work/course.html" || fail "English on a French page"
closed=("${attempt[@]}" --trainee P08 --records "$work/cohort.db" --course "$work/two.json")
expect 0 "notice: groove is closed to P08 in the course two until viscoelastic_removal is passed" "${closed[@]}" --out "$work/c1"
course refuse
expect 2 "groove is closed to P08" "${closed[@]}" --out "$work/c2"
[ ! -e "$work/c2" ] || fail "a closed lesson was begun"
expect 2 "there is no course 'cataratc' (did you mean cataract?)" "$rhexis" records next P07 --records "$work/cohort.db" --course cataratc
echo '{ "lessons": [ { "exercise": "groove", "after": ["navigation"] } ] }' >"$work/two.json"
expect 2 "lesson 1: after: there is no lesson 'navigation' before it" "$rhexis" records next P07 "${some[@]}"
echo '{ "lessons": [ { "exercise": "groov" } ] }' >"$work/two.json"
expect 2 "there is no exercise 'groov' (did you mean groove?)" "$rhexis" records next P07 "${some[@]}"
expect 0 "" "$rhexis" records next P07 --records "$work/cohort.db"  # the course that comes along

# Deleting takes a yes, and takes all.
expect 2 "nothing was deleted" "$rhexis" records delete P07
expect 0 "" "$rhexis" records delete P07 --yes --runs
[ "$(sql "SELECT count(*) FROM attempts WHERE trainee = 'P07'")" = 0 ] || fail "attempts are left of a deleted trainee"
[ "$(sql "SELECT count(*) FROM ratings JOIN attempts USING (attempt)")" = "$(count ratings)" ] || fail "ratings hang loose"
! grep -q P07 "$RHEXIS_RECORDS" || fail "the file still holds the pseudonym"
[ ! -e "$work/p1" ] && [ -e "$work/q1/report.json" ] || fail "the folders of the runs"
expect 2 "nothing is stored of P07" "$rhexis" records delete P07 --yes
finished
