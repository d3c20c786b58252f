// SPDX-License-Identifier: GPL-3.0-or-later
// Inside mesh: words and numbers of a mesh file, with the line they stand on. Numbers may stand there as bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace rhexis {

/// How a number stands in a file where numbers are bytes; of no meaning in text.
struct NumberForm {
    enum Kind { whole, natural, real } kind = whole;  ///< natural: without a sign
    int bytes = 4;                                    ///< 1, 2, 4 or 8
};

/// Reads on after a fault as if every number were 0; the first fault is kept. Callers check `failed()` at each section
/// and inside long loops.
class TokenReader {
public:
    TokenReader(std::string_view text, std::string path) : text_(text), path_(std::move(path)) {}

    /// The next word; empty at the end of the file.
    std::string_view word();
    /// Like word(), but the end of the file is a fault.
    std::string_view needed_word(std::string_view expected);
    /// Whether the next word is this one (letter case is ignored); it stays the next.
    [[nodiscard]] bool next_is(std::string_view word) const;
    /// Whether another word follows on the current line.
    [[nodiscard]] bool next_is_on_this_line() const;
    [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
    /// The rest of the current line.
    std::string_view rest_of_line();
    /// Like rest_of_line(), but the end of the file is a fault.
    std::string_view needed_line(std::string_view expected);
    double number(std::string_view expected, NumberForm form = {NumberForm::real, 8});
    std::int64_t integer(std::string_view expected, std::int64_t low, std::int64_t high, NumberForm form = {});

    /// From the next line on, numbers are bytes, until end_bytes().
    void begin_bytes(bool big_end_first);
    void end_bytes() { bytes_ = false; }
    [[nodiscard]] bool in_bytes() const { return bytes_; }
    void skip_bytes(std::size_t count);
    /// Goes on behind the next such text, whatever stands before it.
    void skip_behind(std::string_view text);

    /// A count of things that take at least `bytes_each` bytes of text each: more than fit into the rest of the file is
    /// a fault, so that a broken count never makes a large allocation.
    std::size_t count(std::string_view of_what, std::size_t bytes_each, NumberForm form = {});

    /// Faults unless the next word is this one (letter case is ignored).
    void expect(std::string_view word);

    void fail(const std::string& what, const std::string& allowed = "");
    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] const Error& error() const { return error_; }
    [[nodiscard]] int line() const { return word_line_; }  ///< of the word last read
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::uint64_t raw(std::string_view expected, int bytes);

    std::string_view text_;
    std::string path_;
    std::size_t at_ = 0;
    int line_ = 1;
    int word_line_ = 1;
    bool bytes_ = false;
    bool big_end_first_ = false;
    bool failed_ = false;
    Error error_;
};

/// Equal but for the case of ASCII letters.
bool same_word(std::string_view a, std::string_view b);

}  // namespace rhexis
