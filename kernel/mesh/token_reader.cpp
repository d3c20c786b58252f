// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/token_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace rhexis {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// A word fit for a message: short and printable.
std::string shown(std::string_view word) {
    std::string text = "\"";
    for (char c : word.substr(0, 30)) {
        text += c >= ' ' && c <= '~' ? c : '?';
    }
    return text + (word.size() > 30 ? "...\"" : "\"");
}

std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::string_view TokenReader::word() {
    while (at_ < text_.size() && is_space(text_[at_])) {
        line_ += text_[at_] == '\n' ? 1 : 0;
        ++at_;
    }
    word_line_ = line_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) {
        ++at_;
    }
    return text_.substr(begin, at_ - begin);
}

std::string_view TokenReader::needed_word(std::string_view expected) {
    const std::string_view next = word();
    if (next.empty()) {
        fail("the file ends early", std::string(expected) + " should follow");
    }
    return next;
}

std::string_view TokenReader::rest_of_line() {
    const std::size_t begin = at_;
    word_line_ = line_;
    while (at_ < text_.size() && text_[at_] != '\n') {
        ++at_;
    }
    std::string_view rest = text_.substr(begin, at_ - begin);
    if (at_ < text_.size()) {
        ++at_;
        ++line_;
    }
    while (!rest.empty() && is_space(rest.back())) {
        rest.remove_suffix(1);
    }
    return rest;
}

void TokenReader::skip_to_empty_line() {
    rest_of_line();
    while (at_ < text_.size() && !rest_of_line().empty()) {
    }
}

double TokenReader::number(std::string_view expected) {
    const std::string_view next = needed_word(expected);
    if (failed_) {
        return 0.0;
    }
    const std::string_view digits = without_plus(next);
    double value = 0.0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size() || code == std::errc::invalid_argument) {
        fail(shown(next) + " is not a number", std::string(expected));
        return 0.0;
    }
    // Out of range: too small reads as 0, too large as infinite, which the mesh check refuses by node.
    if (code == std::errc::result_out_of_range) {
        const bool tiny = digits.find("e-") != std::string_view::npos || digits.find("E-") != std::string_view::npos;
        return tiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    return value;
}

std::int64_t TokenReader::integer(std::string_view expected, std::int64_t low, std::int64_t high) {
    const std::string_view next = needed_word(expected);
    if (failed_) {
        return low;
    }
    const std::string_view digits = without_plus(next);
    std::int64_t value = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size() || code == std::errc::invalid_argument) {
        fail(shown(next) + " is not a whole number", std::string(expected));
        return low;
    }
    if (code != std::errc() || value < low || value > high) {
        fail(std::string(expected) + " is " + shown(next), std::to_string(low) + " to " + std::to_string(high));
        return low;
    }
    return value;
}

std::size_t TokenReader::count(std::string_view of_what, std::size_t bytes_each) {
    const std::int64_t most = std::numeric_limits<std::int64_t>::max();
    const std::int64_t announced = integer("number of " + std::string(of_what), 0, most);
    const std::size_t room = (text_.size() - at_ + 1) / bytes_each;
    if (!failed_ && static_cast<std::uint64_t>(announced) > room) {
        fail("announces " + std::to_string(announced) + " " + std::string(of_what) + ", but the file ends early",
             "at most " + std::to_string(room) + " fit into what follows");
        return 0;
    }
    return static_cast<std::size_t>(announced);
}

void TokenReader::expect(std::string_view wanted) {
    const std::string_view next = needed_word(wanted);
    if (!failed_ && !same_word(next, wanted)) {
        fail(shown(next) + " is not expected here", std::string(wanted));
    }
}

void TokenReader::fail(const std::string& what, const std::string& allowed) {
    if (!failed_) {
        failed_ = true;
        error_ = {what, path_ + ":" + std::to_string(word_line_), allowed};
    }
}

}  // namespace rhexis
