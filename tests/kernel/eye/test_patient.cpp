// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "eye/patient.hpp"

using namespace rhexis;

namespace {

/// A file that is gone when the test ends.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& content)
        : path_(std::filesystem::temp_directory_path() / ("rhexis_patient_" + std::to_string(::getpid()) + ".json")) {
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

std::string fault(const std::string& content) {
    const TemporaryFile file(content);
    const Result<Patient> patient = read_patient(file.path());
    if (patient.ok()) {
        return "";
    }
    const std::string text = patient.error().text();
    REQUIRE(text.find(file.path()) == 0);
    CHECK(text.find('\n') == std::string::npos);
    return text.substr(file.path().size());
}

}  // namespace

TEST_SUITE("eye") {
    TEST_CASE("every patient file of the assets is a valid patient") {
        int count = 0;
        for (const auto& entry : std::filesystem::directory_iterator("assets/patients")) {
            if (entry.path().extension() == ".json") {
                const Result<Patient> patient = read_patient(entry.path().string());
                CHECK_MESSAGE(patient.ok(), (patient.ok() ? "" : patient.error().text()));
                ++count;
            }
        }
        CHECK(count >= 4);
    }

    TEST_CASE("a patient file sets the fields it names and leaves the others at their defaults") {
        const TemporaryFile file(R"({"age": 81, "side": "left", "tetrahedra": 1200, "note": "hard"})");
        const Result<Patient> read = read_patient(file.path());
        REQUIRE(read.ok());
        CHECK(read.value().age == 81);
        CHECK(read.value().side == "left");
        CHECK(read.value().tetrahedra == 1200);
        CHECK(read.value().pupil_mm == Patient{}.pupil_mm);
    }

    TEST_CASE("bad patient files are refused in one line that names the fault") {
        CHECK(fault("{\"age\": 68,\n \"pupil_mm\": }").find(":2: is not JSON") == 0);
        CHECK(fault("[1, 2]").find(": is not a JSON object") == 0);
        CHECK(fault("").find(":1: is not JSON") == 0);
        CHECK(fault(R"({"age": "old"})") == ": age is not a number (20 to 95 years)");
        CHECK(fault(R"({"age": 1e999})") == ": holds a number beyond all range (at most 1e308)");
        CHECK(fault(R"({"age": 130})") == ": age is 130 (20 to 95 years)");
        CHECK(fault(R"({"pupil": 7})").find(": unknown field \"pupil\"") == 0);
        CHECK(fault(R"({"pupil_m": 7})").find("did you mean 'pupil_mm'?") != std::string::npos);
        CHECK(fault(R"({"nucleus_grade": 7})").find("did you mean 'nuclear_grade'?") != std::string::npos);
        CHECK(fault(R"({"sex": 7})")
                  .find("one of age, nuclear_grade, cortical_opacity, pupil_mm, side, tetrahedra, note") !=
              std::string::npos);
        CHECK(fault(R"({"side": 3})").find(": side is not a text") == 0);
        CHECK(fault(R"({"tetrahedra": 3000.5})").find(": tetrahedra is not a whole number") == 0);
        CHECK(fault(R"({"tetrahedra": 1e99})").find(": tetrahedra is not a whole number") == 0);
        CHECK(fault(R"({"tetrahedra": -99999999999999})").find(": tetrahedra is not a whole number") == 0);
        CHECK(fault(std::string(3 << 20, ' ')).find(": has 3145728 bytes (at most 1048576)") == 0);
        CHECK(fault(std::string(200000, '[')).find(":1: is not JSON") == 0);
        CHECK(read_patient("no/such/file.json").error().text() == "no/such/file.json: does not exist");
        CHECK(!read_patient("tests").ok());
    }
}
