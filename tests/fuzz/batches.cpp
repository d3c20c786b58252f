// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/batches.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <sstream>

namespace rhexis::fuzz {
namespace {

constexpr std::uint64_t batch = 100;

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

Outcome guarded(const Case& one, std::uint64_t number) {
    try {
        return one(number);
    } catch (const std::exception& error) {
        return {"threw", 0, std::string("an exception got out: ") + error.what()};
    }
}

/// In the child: a line when a case begins, another when it is over.
[[noreturn]] void work(int pipe, std::uint64_t first, std::uint64_t last, unsigned limit_s, const Case& one) {
    std::FILE* told = fdopen(pipe, "w");
    for (std::uint64_t number = first; number < last; ++number) {
        std::fprintf(told, "begin %llu\n", static_cast<unsigned long long>(number));
        std::fflush(told);
        alarm(limit_s);
        const Outcome outcome = guarded(one, number);
        alarm(0);
        std::fprintf(told, "end %s %llu %s\n", outcome.kind.c_str(), static_cast<unsigned long long>(outcome.steps),
                     one_line(outcome.fault).c_str());
        std::fflush(told);
    }
    std::fclose(told);
    _exit(0);
}

std::string read_all(int pipe) {
    std::string text;
    char buffer[4096];
    for (ssize_t size = read(pipe, buffer, sizeof buffer); size > 0; size = read(pipe, buffer, sizeof buffer)) {
        text.append(buffer, static_cast<std::size_t>(size));
    }
    return text;
}

/// Appends what the child told; a case that began and did not end died by `status`.
void take(const std::string& text, int status, std::vector<Told>& all) {
    std::istringstream lines(text);
    std::string line;
    bool open = false;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "begin") {
            all.emplace_back();
            words >> all.back().number;
            open = true;
        } else if (!all.empty()) {
            Outcome& outcome = all.back().outcome;
            words >> outcome.kind >> outcome.steps;
            std::getline(words >> std::ws, outcome.fault);
            open = false;
        }
    }
    if (open) {
        const bool hung = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
        const int how = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
        all.back().outcome = {hung ? "hung" : "crashed", 0,
                              (WIFSIGNALED(status) ? "signal " : "exit status ") + std::to_string(how)};
    }
}

}  // namespace

std::vector<Told> run_batches(std::uint64_t first, std::uint64_t count, unsigned limit_s, const Case& one) {
    std::vector<Told> all;
    std::uint64_t next = first;
    while (next < first + count) {
        int ends[2];
        if (pipe(ends) != 0) {
            std::perror("pipe");
            return all;
        }
        std::fflush(nullptr);
        const pid_t child = fork();
        if (child == 0) {
            close(ends[0]);
            work(ends[1], next, std::min(next + batch, first + count), limit_s, one);
        }
        close(ends[1]);
        const std::string text = read_all(ends[0]);
        close(ends[0]);
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child) {
            std::perror("fork");
            return all;
        }
        const std::size_t before = all.size();
        take(text, status, all);
        next += std::max<std::size_t>(all.size() - before, 1);
        if (isatty(STDERR_FILENO) != 0) {
            std::fprintf(stderr, "\r%llu of %llu ", static_cast<unsigned long long>(next - first),
                         static_cast<unsigned long long>(count));
        }
    }
    return all;
}

}  // namespace rhexis::fuzz
