// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/process_mark.hpp"

#include <unistd.h>

#include <array>
#include <fstream>
#include <sstream>

namespace rhexis::records {
namespace {

std::string first_word_of(const std::string& path) {
    std::ifstream stream(path);
    std::string word;
    stream >> word;
    return word;
}

std::string link_of(const char* path) {
    std::array<char, 128> text{};
    const ssize_t size = ::readlink(path, text.data(), text.size());
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "-";
}

std::string host() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "-";
}

/// When a process began, in ticks since boot: a later process of the same id began later. Field 22 of proc(5), counted
/// from behind the name, which may hold anything. Empty: there is no such process, or it is a zombie.
std::string began(const std::string& id) {
    std::ifstream stream("/proc/" + id + "/stat");
    std::ostringstream content;
    content << stream.rdbuf();
    const std::string text = content.str();
    const std::size_t behind_name = text.rfind(')');
    if (behind_name == std::string::npos) {
        return {};
    }
    std::istringstream fields(text.substr(behind_name + 1));
    std::string field;
    for (int number = 3; number <= 22 && fields >> field; ++number) {
        if (number == 3 && (field == "Z" || field == "X")) {
            return {};
        }
    }
    return field;
}

std::string place() {
    return host() + " " + first_word_of("/proc/sys/kernel/random/boot_id") + " " + link_of("/proc/self/ns/pid");
}

}  // namespace

std::string process_mark() {
    const std::string id = std::to_string(::getpid());
    return place() + " " + id + " " + began(id);
}

Life life_of(const std::string& mark) {
    std::istringstream fields(mark);
    std::string machine;
    std::string boot;
    std::string space;
    std::string id;
    std::string moment;
    if (!(fields >> machine >> boot >> space >> id >> moment)) {
        return Life::unknown;
    }
    if (machine + " " + boot + " " + space == place()) {
        return began(id) == moment ? Life::alive : Life::gone;
    }
    return machine == host() && boot != first_word_of("/proc/sys/kernel/random/boot_id") ? Life::gone : Life::unknown;
}

}  // namespace rhexis::records
