// SPDX-License-Identifier: GPL-3.0-or-later
// Progress of long work: a bar on a terminal, nothing in a pipe.
#pragma once

#include <string>

namespace rhexis {

class Progress {
public:
    /// Shows on stderr if that is a terminal and `quiet` is false.
    explicit Progress(std::string label, bool quiet = false);
    /// Clears the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// share: 0 to 1 of the work; note: what is being done now. Redraws a few times a second.
    void show(double share, const std::string& note);
    /// Makes room for a line of other output.
    void clear();

private:
    std::string label_;
    bool visible_;
    double start_s_;
    double drawn_s_ = 0.0;
};

}  // namespace rhexis
