// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/pattern.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace rhexis::lua {
namespace {

constexpr std::size_t max_pattern_bytes = 1000;
constexpr std::size_t max_captures = 32;

bool in_class(char letter, int c) {
    switch (std::tolower(static_cast<unsigned char>(letter))) {
        case 'a':
            return std::isalpha(c) != 0;
        case 'c':
            return std::iscntrl(c) != 0;
        case 'd':
            return std::isdigit(c) != 0;
        case 'g':
            return std::isgraph(c) != 0;
        case 'l':
            return std::islower(c) != 0;
        case 'p':
            return std::ispunct(c) != 0;
        case 's':
            return std::isspace(c) != 0;
        case 'u':
            return std::isupper(c) != 0;
        case 'w':
            return std::isalnum(c) != 0;
        case 'x':
            return std::isxdigit(c) != 0;
        case 'z':
            return c == 0;
        default:
            return false;
    }
}

using Set = std::bitset<256>;

// What "%letter" stands for: a class, its complement in upper case, or the character itself.
Set set_of_escaped(char letter) {
    Set set;
    const bool is_class =
        std::string_view("acdglpsuwxz").find(static_cast<char>(std::tolower(static_cast<unsigned char>(letter)))) !=
        std::string_view::npos;
    if (!is_class) {
        return set.set(static_cast<unsigned char>(letter));
    }
    for (int c = 0; c < 256; ++c) {
        set.set(static_cast<std::size_t>(c), in_class(letter, c));
    }
    return std::isupper(static_cast<unsigned char>(letter)) != 0 ? ~set : set;
}

// All of them once: scripts that read text compile small patterns by the thousand.
const Set& escaped_set(char letter) {
    static const std::array<Set, 256> sets = [] {
        std::array<Set, 256> made;
        for (int c = 0; c < 256; ++c) {
            made[static_cast<std::size_t>(c)] = set_of_escaped(static_cast<char>(c));
        }
        return made;
    }();
    return sets[static_cast<unsigned char>(letter)];
}

}  // namespace

// ---- from text to items

class PatternCompiler {
public:
    PatternCompiler(std::string_view text, Pattern& pattern) : text_(text), pattern_(pattern) {}

    void compile(bool anchors) {
        if (text_.size() > max_pattern_bytes) {
            throw PatternError("malformed pattern (longer than " + std::to_string(max_pattern_bytes) + " bytes)");
        }
        if (anchors && text_.starts_with('^')) {
            pattern_.anchored_ = true;
            ++at_;
        }
        while (at_ < text_.size()) {
            add_item();
        }
        if (!open_.empty()) {
            throw PatternError("unfinished capture");
        }
        pattern_.captures_ = captures_;
    }

private:
    void add_item() {
        const char c = text_[at_];
        if (c == '(') {
            open_capture();
        } else if (c == ')') {
            close_capture();
        } else if (c == '$' && at_ + 1 == text_.size()) {
            ++at_;
            push(Pattern::Kind::end);
        } else if (c == '%' && at_ + 1 < text_.size() && is_special(text_[at_ + 1])) {
            add_special(text_[at_ + 1]);
        } else {
            Pattern::Item& item = push(Pattern::Kind::set);
            item.set = read_set();
            item.repeat = read_repeat();
        }
    }

    static bool is_special(char c) { return c == 'b' || c == 'f' || std::isdigit(static_cast<unsigned char>(c)) != 0; }

    Pattern::Item& push(Pattern::Kind kind) {
        pattern_.items_.emplace_back();
        pattern_.items_.back().kind = kind;
        return pattern_.items_.back();
    }

    void open_capture() {
        if (captures_ == max_captures) {
            throw PatternError("too many captures");
        }
        const bool position = text_.substr(at_, 2) == "()";
        push(position ? Pattern::Kind::open_position : Pattern::Kind::open).capture = captures_;
        if (!position) {
            open_.push_back(captures_);
        }
        ++captures_;
        at_ += position ? 2 : 1;
    }

    void close_capture() {
        if (open_.empty()) {
            throw PatternError("invalid pattern capture");
        }
        push(Pattern::Kind::close).capture = open_.back();
        open_.pop_back();
        ++at_;
    }

    void add_special(char c) {
        at_ += 2;
        if (c == 'b') {
            if (at_ + 2 > text_.size()) {
                throw PatternError("malformed pattern (missing arguments to '%b')");
            }
            Pattern::Item& item = push(Pattern::Kind::balance);
            item.open = static_cast<unsigned char>(text_[at_]);
            item.close = static_cast<unsigned char>(text_[at_ + 1]);
            at_ += 2;
        } else if (c == 'f') {
            if (at_ >= text_.size() || text_[at_] != '[') {
                throw PatternError("missing '[' after '%f' in pattern");
            }
            const Set set = read_set();
            push(Pattern::Kind::frontier).set = set;
        } else {
            add_back_reference(c);
        }
    }

    void add_back_reference(char digit) {
        const std::size_t capture = static_cast<std::size_t>(digit - '1');
        if (digit == '0' || capture >= captures_ || std::find(open_.begin(), open_.end(), capture) != open_.end()) {
            throw PatternError(std::string("invalid capture index %") + digit);
        }
        push(Pattern::Kind::back_reference).capture = capture;
    }

    Set read_set() {
        const char c = text_[at_++];
        if (c == '[') {
            return read_bracket();
        }
        if (c == '%') {
            if (at_ >= text_.size()) {
                throw PatternError("malformed pattern (ends with '%')");
            }
            return escaped_set(text_[at_++]);
        }
        Set set;
        return c == '.' ? set.set() : set.set(static_cast<unsigned char>(c));
    }

    Set read_bracket() {
        Set set;
        const bool complement = at_ < text_.size() && text_[at_] == '^';
        at_ += complement ? 1 : 0;
        for (bool first = true;; first = false) {
            if (at_ >= text_.size() || (text_[at_] == '%' && at_ + 1 >= text_.size())) {
                throw PatternError("malformed pattern (missing ']')");
            }
            if (text_[at_] == ']' && !first) {
                ++at_;
                return complement ? ~set : set;
            }
            add_to_bracket(set);
        }
    }

    void add_to_bracket(Set& set) {
        if (text_[at_] == '%') {
            set |= escaped_set(text_[at_ + 1]);
            at_ += 2;
        } else if (at_ + 2 < text_.size() && text_[at_ + 1] == '-' && text_[at_ + 2] != ']') {
            for (int c = static_cast<unsigned char>(text_[at_]); c <= static_cast<unsigned char>(text_[at_ + 2]); ++c) {
                set.set(static_cast<std::size_t>(c));
            }
            at_ += 3;
        } else {
            set.set(static_cast<unsigned char>(text_[at_++]));
        }
    }

    Pattern::Repeat read_repeat() {
        switch (at_ < text_.size() ? text_[at_++] : '\0') {
            case '*':
                return Pattern::Repeat::star;
            case '+':
                return Pattern::Repeat::plus;
            case '-':
                return Pattern::Repeat::lazy;
            case '?':
                return Pattern::Repeat::optional;
            case '\0':
                break;
            default:
                --at_;
        }
        return Pattern::Repeat::once;
    }

    std::string_view text_;
    Pattern& pattern_;
    std::size_t at_ = 0;
    std::size_t captures_ = 0;
    std::vector<std::size_t> open_;
};

Pattern::Pattern(std::string_view text, bool anchors) { PatternCompiler(text, *this).compile(anchors); }

// ---- matching: backtracks by recursion, whose depth is bounded by the number of items

class PatternMatcher {
public:
    PatternMatcher(const Pattern& pattern, std::string_view subject, long long& steps)
        : items_(pattern.items_), subject_(subject), steps_(steps), captures_(pattern.captures_) {}

    /// End of the match of items[item...] from `at`.
    std::optional<std::size_t> match(std::size_t item, std::size_t at) {
        while (item < items_.size()) {
            step();
            const Pattern::Item& now = items_[item];
            if (now.kind == Pattern::Kind::set && now.repeat != Pattern::Repeat::once) {
                return match_repeated(item, at);
            }
            if (now.kind == Pattern::Kind::open || now.kind == Pattern::Kind::open_position ||
                now.kind == Pattern::Kind::close) {
                return match_capture(item, at);
            }
            const std::optional<std::size_t> next = match_simple(now, at);
            if (!next) {
                return std::nullopt;
            }
            at = *next;
            ++item;
        }
        return at;
    }

    std::vector<PatternCapture>& captures() { return captures_; }

private:
    void step(long long count = 1) {
        steps_ -= count;
        if (steps_ < 0) {
            throw PatternError("pattern takes too many steps on this text");
        }
    }

    [[nodiscard]] bool fits(const Pattern::Item& item, std::size_t at) const {
        return at < subject_.size() && item.set.test(static_cast<unsigned char>(subject_[at]));
    }

    std::optional<std::size_t> match_simple(const Pattern::Item& item, std::size_t at) {
        switch (item.kind) {
            case Pattern::Kind::set:
                return fits(item, at) ? std::optional(at + 1) : std::nullopt;
            case Pattern::Kind::end:
                return at == subject_.size() ? std::optional(at) : std::nullopt;
            case Pattern::Kind::frontier:
                return at_frontier(item, at) ? std::optional(at) : std::nullopt;
            case Pattern::Kind::balance:
                return match_balance(item, at);
            default:
                return match_back_reference(item, at);
        }
    }

    [[nodiscard]] bool at_frontier(const Pattern::Item& item, std::size_t at) const {
        const auto before = static_cast<unsigned char>(at > 0 ? subject_[at - 1] : '\0');
        const auto after = static_cast<unsigned char>(at < subject_.size() ? subject_[at] : '\0');
        return !item.set.test(before) && item.set.test(after);
    }

    std::optional<std::size_t> match_balance(const Pattern::Item& item, std::size_t at) {
        if (at >= subject_.size() || static_cast<unsigned char>(subject_[at]) != item.open) {
            return std::nullopt;
        }
        int depth = 1;
        for (std::size_t k = at + 1; k < subject_.size(); ++k) {
            step();
            const auto c = static_cast<unsigned char>(subject_[k]);
            if (c == item.close) {
                if (--depth == 0) {
                    return k + 1;
                }
            } else if (c == item.open) {
                ++depth;
            }
        }
        return std::nullopt;
    }

    std::optional<std::size_t> match_back_reference(const Pattern::Item& item, std::size_t at) {
        const PatternCapture& capture = captures_[item.capture];
        const std::string_view text = subject_.substr(capture.begin, capture.end - capture.begin);
        step(static_cast<long long>(text.size()));
        return subject_.substr(at).starts_with(text) ? std::optional(at + text.size()) : std::nullopt;
    }

    std::optional<std::size_t> match_capture(std::size_t item, std::size_t at) {
        const Pattern::Item& now = items_[item];
        PatternCapture& capture = captures_[now.capture];
        const PatternCapture before = capture;
        if (now.kind == Pattern::Kind::close) {
            capture.end = at;
        } else {
            capture = {at, at, now.kind == Pattern::Kind::open_position};
        }
        const std::optional<std::size_t> end = match(item + 1, at);
        if (!end) {
            capture = before;
        }
        return end;
    }

    std::optional<std::size_t> match_repeated(std::size_t item, std::size_t at) {
        const Pattern::Item& now = items_[item];
        if (now.repeat == Pattern::Repeat::lazy) {
            return match_lazy(item, at);
        }
        const std::size_t most = now.repeat == Pattern::Repeat::optional ? 1 : subject_.size();
        const std::size_t least = now.repeat == Pattern::Repeat::plus ? 1 : 0;
        std::size_t count = 0;
        while (count < most && fits(now, at + count)) {
            step();
            ++count;
        }
        for (; count + 1 > least; --count) {
            if (const std::optional<std::size_t> end = match(item + 1, at + count)) {
                return end;
            }
            if (count == 0) {
                break;
            }
        }
        return std::nullopt;
    }

    std::optional<std::size_t> match_lazy(std::size_t item, std::size_t at) {
        for (;; ++at) {
            step();
            if (const std::optional<std::size_t> end = match(item + 1, at)) {
                return end;
            }
            if (!fits(items_[item], at)) {
                return std::nullopt;
            }
        }
    }

    const std::vector<Pattern::Item>& items_;
    std::string_view subject_;
    long long& steps_;
    std::vector<PatternCapture> captures_;
};

std::optional<PatternMatch> Pattern::match_at(std::string_view subject, std::size_t at, long long& steps) const {
    PatternMatcher matcher(*this, subject, steps);
    const std::optional<std::size_t> end = matcher.match(0, at);
    if (!end) {
        return std::nullopt;
    }
    return PatternMatch{at, *end, std::move(matcher.captures())};
}

}  // namespace rhexis::lua
