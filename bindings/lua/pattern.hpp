// SPDX-License-Identifier: GPL-3.0-or-later
// Lua patterns with counted work. The stock matcher backtracks without limit inside one C call, where no hook fires;
// this one has the same language (Lua 5.4 reference manual, section 6.4.1) and stops after a number of steps.
#pragma once

#include <bitset>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace rhexis::lua {

/// A malformed pattern, or one that needs too many steps.
class PatternError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct PatternCapture {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool position = false;  ///< "()": only begin counts
};

struct PatternMatch {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::vector<PatternCapture> captures;
};

class Pattern {
public:
    /// Throws PatternError on a malformed pattern, or one longer than 1000 bytes. anchors: "^" at the start anchors
    /// (not so in gmatch).
    Pattern(std::string_view text, bool anchors);

    [[nodiscard]] bool anchored() const { return anchored_; }

    /// Match that begins at `at`. Takes each step from `steps` and throws PatternError when they are used up.
    std::optional<PatternMatch> match_at(std::string_view subject, std::size_t at, long long& steps) const;

private:
    friend class PatternCompiler;
    friend class PatternMatcher;

    enum class Kind { set, open, open_position, close, back_reference, balance, frontier, end };
    enum class Repeat { once, star, plus, lazy, optional };
    struct Item {
        Kind kind = Kind::set;
        Repeat repeat = Repeat::once;
        std::bitset<256> set;  // set, frontier
        std::size_t capture = 0;
        unsigned char open = 0;  // balance
        unsigned char close = 0;
    };
    std::vector<Item> items_;
    std::size_t captures_ = 0;
    bool anchored_ = false;
};

}  // namespace rhexis::lua
