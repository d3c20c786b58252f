// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/schema.hpp"

namespace rhexis::records {

std::vector<const char*> schema_statements() {
    return {
        "CREATE TABLE trainees (trainee TEXT PRIMARY KEY, cohort TEXT NOT NULL, arm TEXT NOT NULL)",

        "CREATE TABLE attempts ("
        "  attempt TEXT PRIMARY KEY,"
        "  trainee TEXT NOT NULL REFERENCES trainees ON DELETE CASCADE,"
        "  cohort TEXT NOT NULL, arm TEXT NOT NULL,"
        "  exercise TEXT NOT NULL, title TEXT NOT NULL, version REAL NOT NULL, sha256 TEXT NOT NULL,"
        "  surgeon TEXT NOT NULL, seed TEXT NOT NULL,"
        "  begun TEXT NOT NULL, process TEXT NOT NULL, folder TEXT NOT NULL,"
        "  finished INTEGER NOT NULL DEFAULT 0,"
        "  ended TEXT NOT NULL DEFAULT '', completed INTEGER NOT NULL DEFAULT 0,"
        "  duration_s REAL NOT NULL DEFAULT 0, patient TEXT NOT NULL DEFAULT '', settings TEXT NOT NULL DEFAULT '',"
        "  level TEXT NOT NULL DEFAULT '', mode TEXT NOT NULL DEFAULT '', language TEXT NOT NULL DEFAULT '',"
        "  rubric TEXT NOT NULL DEFAULT '', total REAL, max REAL, scaled REAL,"
        "  error TEXT NOT NULL DEFAULT '', recording_sha256 TEXT NOT NULL DEFAULT '',"
        "  begun_at TEXT NOT NULL DEFAULT '', input TEXT NOT NULL DEFAULT '', aids TEXT NOT NULL DEFAULT '')",
        "CREATE INDEX attempts_of_trainee ON attempts (trainee, exercise, begun)",

        "CREATE TABLE items ("
        "  attempt TEXT NOT NULL REFERENCES attempts ON DELETE CASCADE,"
        "  item TEXT NOT NULL, name TEXT NOT NULL, score REAL, capped_by TEXT NOT NULL,"
        "  PRIMARY KEY (attempt, item)) WITHOUT ROWID",

        "CREATE TABLE measures ("
        "  attempt TEXT NOT NULL REFERENCES attempts ON DELETE CASCADE,"
        "  measure TEXT NOT NULL, name TEXT NOT NULL, value REAL, unit TEXT NOT NULL, score REAL,"
        "  PRIMARY KEY (attempt, measure)) WITHOUT ROWID",

        "CREATE TABLE events ("
        "  attempt TEXT NOT NULL REFERENCES attempts ON DELETE CASCADE,"
        "  number INTEGER NOT NULL, time_s REAL NOT NULL, step TEXT NOT NULL, event TEXT NOT NULL,"
        "  severity TEXT NOT NULL, recovered INTEGER NOT NULL, recovery_s REAL,"
        "  PRIMARY KEY (attempt, number)) WITHOUT ROWID",

        "CREATE TABLE ratings ("
        "  attempt TEXT NOT NULL REFERENCES attempts ON DELETE CASCADE,"
        "  rater TEXT NOT NULL, rated TEXT NOT NULL, comment TEXT NOT NULL,"
        "  PRIMARY KEY (attempt, rater)) WITHOUT ROWID",

        "CREATE TABLE rated_items ("
        "  attempt TEXT NOT NULL, rater TEXT NOT NULL, item TEXT NOT NULL,"
        "  score INTEGER, comment TEXT NOT NULL,"
        "  PRIMARY KEY (attempt, rater, item),"
        "  FOREIGN KEY (attempt, rater) REFERENCES ratings ON DELETE CASCADE) WITHOUT ROWID",
    };
}

std::vector<const char*> upgrade_statements(int from_version) {
    std::vector<const char*> statements;
    if (from_version < 2) {  // where an attempt began was not kept: all count as begun at the beginning
        statements.push_back("ALTER TABLE attempts ADD COLUMN begun_at TEXT NOT NULL DEFAULT ''");
    }
    if (from_version < 3) {  // virtual surgeons had no devices, and nobody aids
        statements.push_back("ALTER TABLE attempts ADD COLUMN input TEXT NOT NULL DEFAULT ''");
        statements.push_back("ALTER TABLE attempts ADD COLUMN aids TEXT NOT NULL DEFAULT ''");
    }
    return statements;
}

}  // namespace rhexis::records
