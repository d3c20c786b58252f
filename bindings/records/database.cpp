// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/database.hpp"

#include <unistd.h>

#include <filesystem>

#include "records/schema.hpp"

namespace rhexis::records {
namespace {

namespace fs = std::filesystem;

// Result codes of SQLite (sqlite3.h), without the macros of that header, which SOCI puts into a namespace.
constexpr int busy = 5, locked = 6, read_only = 8, input_output = 10, corrupt = 11, full = 13, cannot_open = 14,
              not_a_database = 26;

constexpr int wait_s = 5;  // for another program that writes

int code_of(const std::exception& thrown) {
    const auto* error = dynamic_cast<const soci::sqlite3_soci_error*>(&thrown);
    return error != nullptr ? error->result() & 0xff : 0;
}

int number(soci::session& sql, const std::string& query) {
    int value = 0;
    sql << query, soci::into(value);
    return value;
}

void make_tables(soci::session& sql) {
    Writing writing(sql);
    if (number(sql, "PRAGMA user_version") == 0) {  // else another program was faster
        for (const char* statement : schema_statements()) {
            sql << statement;
        }
        sql << "PRAGMA application_id = " + std::to_string(application_id);
        sql << "PRAGMA user_version = " + std::to_string(schema_version);
    }
    writing.commit();
}

/// In one transaction: another program that opens the store meanwhile finds it as it was or as it is to be.
void upgrade(soci::session& sql) {
    Writing writing(sql);
    const int version = number(sql, "PRAGMA user_version");
    for (const char* statement : upgrade_statements(version)) {
        sql << statement;
    }
    if (version < schema_version) {
        sql << "PRAGMA user_version = " + std::to_string(schema_version);
    }
    writing.commit();
}

Status check_version(soci::session& sql, const std::string& path) {
    const int version = number(sql, "PRAGMA user_version");
    if (number(sql, "PRAGMA application_id") != application_id) {
        return Error{"this is no record store of rhexis but another database", path, "--records FILE"};
    }
    if (version > schema_version) {
        return Error{"the record store has schema " + std::to_string(version) + ", made by a newer rhexis", path,
                     "this one reads schema " + std::to_string(schema_version) + "; nothing was changed"};
    }
    return success();
}

}  // namespace

Error database_error(const std::string& path, const std::exception& thrown) {
    switch (code_of(thrown)) {
        case busy:
        case locked:
            return {"locked by another program for more than " + std::to_string(wait_s) + " s", path, "try again"};
        case read_only:
            return {"the record store cannot be written: it or its folder is read-only", path, "--records FILE"};
        case full:
            return {"the record store cannot be written: the disk is full", path, "make room and try again"};
        case input_output:
            return {"the record store cannot be read or written: the disk fails or is full", path,
                    "make room and try again"};
        case corrupt:
            return {"the record store is damaged", path, "a copy of it; 'sqlite3 FILE .recover' may save what is left"};
        case not_a_database:
            return {"this is no record store, or it is damaged", path, "--records FILE"};
        case cannot_open:
            return {"the record store cannot be opened", path, "a file in a folder that can be written"};
        default:
            return {std::string("the record store: ") + thrown.what(), path, ""};
    }
}

Writing::Writing(soci::session& sql) : sql_(sql) { sql_ << "BEGIN IMMEDIATE"; }

Writing::~Writing() {
    if (open_) {
        try {
            sql_ << "ROLLBACK";
        } catch (const std::exception&) {
            // SQLite has undone it already, or does so when the file is next opened
        }
    }
}

void Writing::commit() {
    sql_ << "COMMIT";
    open_ = false;
}

Status open_database(soci::session& sql, const std::string& path, Opening how) {
    std::error_code failed;
    if (path.empty()) {  // as default_store says it
        return Error{"there is no place for a record store: neither HOME nor XDG_DATA_HOME is set", "",
                     "--records FILE, or RHEXIS_RECORDS"};
    }
    if (path.find('"') != std::string::npos) {
        return Error{"no name for a record store", path, "a path without quotation marks"};
    }
    if (fs::is_directory(path, failed)) {
        return Error{"this is a folder", path, "--records FILE"};
    }
    const bool there = fs::exists(path, failed) && fs::file_size(path, failed) > 0;
    if (!there && how == Opening::existing) {
        return Error{"there is no record store", path,
                     "rhexis run EXERCISE --trainee PSEUDONYM begins one; --records FILE names another"};
    }
    const fs::path folder = fs::path(path).parent_path();
    if (!there && !folder.empty()) {
        fs::create_directories(folder, failed);
        if (failed) {
            return Error{"the record store cannot be made: " + failed.message(), path,
                         "a file in a folder that can be written"};
        }
    }
    sql.open(soci::sqlite3, "dbname=\"" + path + "\" timeout=" + std::to_string(wait_s));
    // A commit is on the disk when it returns, its journal's folder included. No write-ahead log: it needs shared
    // memory, which network folders of hospitals lack, and a store is written a few times an hour.
    sql << "PRAGMA synchronous = EXTRA";
    sql << "PRAGMA foreign_keys = ON";
    sql << "PRAGMA secure_delete = ON";
    if (number(sql, "PRAGMA user_version") == 0 && number(sql, "SELECT count(*) FROM sqlite_master") == 0) {
        make_tables(sql);
    }
    Status readable = check_version(sql, path);
    if (readable && number(sql, "PRAGMA user_version") < schema_version) {
        upgrade(sql);
    }
    return readable;
}

}  // namespace rhexis::records
