// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/token_reader.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace rhexis {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

/// Lines end with \n, \r\n, or \r alone.
bool ends_line(std::string_view text, std::size_t at) {
    return text[at] == '\n' || (text[at] == '\r' && (at + 1 == text.size() || text[at + 1] != '\n'));
}

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
        line_ += ends_line(text_, at_) ? 1 : 0;
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
    while (at_ < text_.size() && !ends_line(text_, at_)) {
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

std::string_view TokenReader::needed_line(std::string_view expected) {
    if (at_end()) {
        fail("the file ends early", std::string(expected) + " should follow");
    }
    return rest_of_line();
}

bool TokenReader::next_is(std::string_view wanted) const {
    std::size_t begin = at_;
    while (begin < text_.size() && is_space(text_[begin])) {
        ++begin;
    }
    std::size_t end = begin;
    while (end < text_.size() && end - begin <= wanted.size() && !is_space(text_[end])) {
        ++end;
    }
    return same_word(text_.substr(begin, end - begin), wanted);
}

bool TokenReader::next_is_on_this_line() const {
    std::size_t at = at_;
    while (at < text_.size() && !ends_line(text_, at) && is_space(text_[at])) {
        ++at;
    }
    return at < text_.size() && !is_space(text_[at]);
}

void TokenReader::begin_bytes(bool big_end_first) {
    rest_of_line();
    bytes_ = true;
    big_end_first_ = big_end_first;
}

void TokenReader::skip_bytes(std::size_t count) {
    if (count > text_.size() - at_) {
        fail("the file ends early", std::to_string(count) + " bytes should follow");
        return;
    }
    at_ += count;
}

void TokenReader::skip_behind(std::string_view text) {
    const std::size_t found = text_.find(text, at_);
    if (found == std::string_view::npos) {
        fail("the file ends early", std::string(text) + " should follow");
        return;
    }
    for (; at_ < found; ++at_) {
        line_ += ends_line(text_, at_) ? 1 : 0;
    }
    at_ += text.size();
}

std::uint64_t TokenReader::raw(std::string_view expected, int bytes) {
    const std::size_t count = static_cast<std::size_t>(bytes);
    if (failed_ || count > text_.size() - at_) {
        fail("the file ends early", std::string(expected) + " should follow");
        return 0;
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t from_low = big_end_first_ ? count - 1 - i : i;
        value |= std::uint64_t{static_cast<unsigned char>(text_[at_ + i])} << (8 * from_low);
    }
    at_ += count;
    return value;
}

double TokenReader::number(std::string_view expected, NumberForm form) {
    if (bytes_) {
        if (form.kind == NumberForm::real) {
            const std::uint64_t bits = raw(expected, form.bytes);
            return form.bytes == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                                   : std::bit_cast<double>(bits);
        }
        constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
        return static_cast<double>(integer(expected, -most, most, form));
    }
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

std::int64_t TokenReader::integer(std::string_view expected, std::int64_t low, std::int64_t high, NumberForm form) {
    if (bytes_) {
        const std::uint64_t bits = raw(expected, form.bytes);
        const int unused = 64 - 8 * form.bytes;
        const std::int64_t value = form.kind == NumberForm::whole ? static_cast<std::int64_t>(bits << unused) >> unused
                                                                  : static_cast<std::int64_t>(bits);
        const bool too_large = form.kind == NumberForm::natural && value < 0;
        if (!failed_ && (too_large || value < low || value > high)) {
            fail(std::string(expected) + " is " + (too_large ? std::to_string(bits) : std::to_string(value)),
                 std::to_string(low) + " to " + std::to_string(high));
        }
        return failed_ ? low : value;
    }
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

std::size_t TokenReader::count(std::string_view of_what, std::size_t bytes_each, NumberForm form) {
    const std::int64_t most = std::numeric_limits<std::int64_t>::max();
    const std::int64_t announced = integer("number of " + std::string(of_what), 0, most, form);
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
        const std::string place = bytes_ ? ", byte " + std::to_string(at_) : ":" + std::to_string(word_line_);
        error_ = {what, path_ + place, allowed};
    }
}

}  // namespace rhexis
