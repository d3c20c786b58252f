// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mutate.hpp"

#include <array>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

namespace rhexis::fuzz {
namespace {

constexpr std::array<const char*, 14> odd_numbers{
    "0",   "-1",  "1e308", "1e-308",     "0/0", "1/0", "65535",
    "1e9", "0.5", "-0.0",  "2147483648", "nil", "{}",  "0x7fffffffffffffff"};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::size_t end_of_quoted(std::string_view text, std::size_t at) {
    const char quote = text[at];
    std::size_t end = at + 1;
    while (end < text.size() && text[end] != quote && text[end] != '\n') {
        end += text[end] == '\\' ? 2 : 1;
    }
    return std::min(end + 1, text.size());
}

std::size_t end_of_token(std::string_view text, std::size_t at) {
    if (text[at] == '"' || text[at] == '\'') {
        return end_of_quoted(text, at);
    }
    std::size_t end = at + 1;
    if (is_word(text[at])) {
        while (end < text.size() && (is_word(text[end]) || (text[end] == '.' && std::isdigit(text[at]) != 0))) {
            ++end;
        }
    } else if (std::isspace(static_cast<unsigned char>(text[at])) != 0) {
        while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end])) != 0) {
            ++end;
        }
    }
    return end;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Numbers, comparisons, "and", "or" and names of measures ("groove.depth_mm"), in the order of the text.
std::vector<std::string_view> meaningful(std::string_view text) {
    std::vector<std::string_view> found;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        if (text[at] == '<' || text[at] == '>') {
            end += end < text.size() && text[end] == '=' ? 1 : 0;
            found.push_back(text.substr(at, end - at));
        } else if (is_word(text[at])) {
            while (end < text.size() && (is_word(text[end]) || text[end] == '.')) {
                ++end;
            }
            const std::string_view word = text.substr(at, end - at);
            if (is_digit(word[0]) || word == "and" || word == "or" || word.find('.') != std::string_view::npos) {
                found.push_back(word);
            }
        }
        at = end;
    }
    return found;
}

/// What stands in place of a word that means something; another: a word of the same text. Empty: it stays.
std::string other_meaning(std::string_view word, std::string_view another, Random& random) {
    if (is_digit(word[0])) {
        static constexpr std::array<double, 6> factors{0.0, 0.5, 0.9, 1.1, 2.0, 10.0};
        return std::to_string(std::strtod(std::string(word).c_str(), nullptr) * factors[pick(random, factors.size())]);
    }
    if (word[0] == '<' || word[0] == '>') {
        return pick(random, 2) == 0 ? "<" : ">=";
    }
    if (word == "and" || word == "or") {
        return word == "and" ? "or" : "and";
    }
    const bool name = another.find('.') != std::string_view::npos && !is_digit(another[0]);
    return name ? std::string(another) : std::string();
}

/// A text in quotes is often a condition: what is in it is spoilt the same way.
std::string spoil_token(const std::string& token, Random& random) {
    if (token.size() > 4 && (token[0] == '"' || token[0] == '\'')) {
        std::vector<std::string> inner = tokens_of(std::string_view(token).substr(1, token.size() - 2));
        std::swap(inner[pick(random, inner.size())], inner[pick(random, inner.size())]);
        if (pick(random, 2) == 0) {
            inner[pick(random, inner.size())] = odd_numbers[pick(random, 8)];
        }
        std::string joined(1, token[0]);
        for (const std::string& part : inner) {
            joined += part;
        }
        return joined + token[0];
    }
    return odd_numbers[pick(random, odd_numbers.size())];
}

/// 'n' number, 'w' word, 'q' text in quotes, ' ' space, else a sign.
char kind_of(const std::string& token) {
    if (token.empty() || std::isspace(static_cast<unsigned char>(token[0])) != 0) {
        return ' ';
    }
    if (token[0] == '"' || token[0] == '\'') {
        return 'q';
    }
    return !is_word(token[0]) ? token[0] : std::isdigit(static_cast<unsigned char>(token[0])) != 0 ? 'n' : 'w';
}

/// A token that is no space.
std::size_t pick_token(const std::vector<std::string>& tokens, Random& random) {
    for (int tries = 0; tries < 50; ++tries) {
        const std::size_t at = pick(random, tokens.size());
        if (kind_of(tokens[at]) != ' ') {
            return at;
        }
    }
    return 0;
}

/// Most changes keep the kind of a token, so that the text still reads as a curriculum and goes wrong later.
void change_tokens(std::vector<std::string>& tokens, Random& random) {
    std::size_t at = pick_token(tokens, random);
    std::size_t other = pick_token(tokens, random);
    if (pick(random, 4) != 0) {
        for (int tries = 0; tries < 50 && !(kind_of(tokens[at]) == 'n' || kind_of(tokens[at]) == 'q'); ++tries) {
            at = pick_token(tokens, random);
        }
        for (int tries = 0; tries < 50 && kind_of(tokens[at]) != kind_of(tokens[other]); ++tries) {
            other = pick_token(tokens, random);
        }
        if (pick(random, 2) == 0) {
            std::swap(tokens[at], tokens[other]);
        } else {
            tokens[at] = kind_of(tokens[at]) == kind_of(tokens[other]) && pick(random, 2) == 0
                             ? tokens[other]
                             : spoil_token(tokens[at], random);
        }
        return;
    }
    switch (pick(random, 4)) {
        case 0:
            tokens[at].clear();
            break;
        case 1:
            tokens[at] += tokens[at];
            break;
        case 2:
            std::swap(tokens[at], tokens[other]);
            break;
        default:
            tokens[at] = tokens[other];
    }
}

void overwrite(std::string& bytes, std::size_t at, Random& random) {
    static constexpr std::array<double, 8> odd{0.0,   -1.0, 1e308,  std::numeric_limits<double>::quiet_NaN(),
                                               1e-30, 1e6,  -1e300, std::numeric_limits<double>::infinity()};
    std::uint64_t word = random();
    if (pick(random, 2) == 0) {
        std::memcpy(&word, &odd[pick(random, odd.size())], sizeof word);
    }
    const std::size_t size = std::min(pick(random, 2) == 0 ? std::size_t{8} : std::size_t{4}, bytes.size() - at);
    std::memcpy(bytes.data() + at, &word, size);
}

void change_bytes(std::string& bytes, Random& random) {
    const std::size_t at = pick(random, bytes.size());
    const std::size_t size = 1 + pick(random, std::min<std::size_t>(64, bytes.size() - at));
    switch (pick(random, 7)) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << pick(random, 8)));
            break;
        case 1:
            bytes[at] = static_cast<char>(random());
            break;
        case 2:
            bytes.insert(at, size, static_cast<char>(random()));
            break;
        case 3:
            bytes.erase(at, size);
            break;
        case 4:
            bytes.insert(at, bytes.substr(at, size));
            break;
        case 5:
            overwrite(bytes, at, random);
            break;
        default:
            bytes.resize(pick(random, 4) == 0 ? at : bytes.size());
    }
}

}  // namespace

std::size_t pick(Random& random, std::size_t below) { return static_cast<std::size_t>(random() % below); }

std::vector<std::string> tokens_of(std::string_view text) {
    std::vector<std::string> tokens;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = end_of_token(text, at);
        tokens.emplace_back(text.substr(at, end - at));
        at = end;
    }
    return tokens;
}

std::string mutate_tokens(const std::string& text, Random& random) {
    std::vector<std::string> tokens = tokens_of(text);
    for (std::size_t n = 1 + pick(random, 3); n > 0 && !tokens.empty(); --n) {
        change_tokens(tokens, random);
    }
    std::string joined;
    for (const std::string& token : tokens) {
        joined += token;
    }
    return joined;
}

std::string mutate_meaning(const std::string& text, Random& random) {
    std::string changed = text;
    for (std::size_t n = 1 + pick(random, 5); n > 0; --n) {
        const std::vector<std::string_view> words = meaningful(changed);
        if (words.empty()) {
            break;
        }
        const std::string_view word = words[pick(random, words.size())];
        const std::string instead = other_meaning(word, words[pick(random, words.size())], random);
        if (!instead.empty()) {
            changed.replace(static_cast<std::size_t>(word.data() - changed.data()), word.size(), instead);
        }
    }
    return changed;
}

std::string mutate_bytes(const std::string& bytes, Random& random) {
    std::string changed = bytes;
    for (std::size_t n = 1 + pick(random, 4); n > 0 && !changed.empty(); --n) {
        change_bytes(changed, random);
    }
    return changed;
}

}  // namespace rhexis::fuzz
