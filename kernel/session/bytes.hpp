// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, texts and lists as little-endian bytes, written and read in the same order. A reader that runs out of bytes
// says so once and gives zeros from there; it never reads outside and never allocates more than the bytes could fill.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

static_assert(std::endian::native == std::endian::little);

class ByteWriter {
public:
    template <typename T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void put(T value) { put_raw(&value, sizeof value); }
    void put(const std::string& text) {
        put(static_cast<std::uint64_t>(text.size()));
        put_raw(text.data(), text.size());
    }
    void put(const Vec3& v) { put_raw(v.data(), 3 * sizeof(double)); }
    void put(const Vec6& v) { put_raw(v.data(), 6 * sizeof(double)); }
    void put(const Quat& q) { put_raw(q.coeffs().data(), 4 * sizeof(double)); }
    void put(const Pose& pose) {
        put(pose.position);
        put(pose.orientation);
    }
    template <typename T>
    void put(const std::vector<T>& list) {
        put(static_cast<std::uint64_t>(list.size()));
        for (const T& item : list) {
            put(item);
        }
    }
    void put(const std::map<std::string, double>& map) {
        put(static_cast<std::uint64_t>(map.size()));
        for (const auto& [name, value] : map) {
            put(name);
            put(value);
        }
    }

    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    void put_raw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

    std::string bytes_;
};

class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

    /// False as soon as a read went past the end.
    [[nodiscard]] bool ok() const { return ok_; }
    [[nodiscard]] bool at_end() const { return next_ == bytes_.size(); }

    template <typename T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void get(T& value) { get_raw(&value, sizeof value); }
    /// A byte that is neither 0 nor 1 is no bool.
    void get(bool& value) {
        std::uint8_t byte = 0;
        get(byte);
        ok_ = ok_ && byte <= 1;
        value = byte == 1;
    }
    void get(std::string& text) {
        text.resize(count(1));
        get_raw(text.data(), text.size());
    }
    void get(Vec3& v) { get_raw(v.data(), 3 * sizeof(double)); }
    void get(Vec6& v) { get_raw(v.data(), 6 * sizeof(double)); }
    void get(Quat& q) { get_raw(q.coeffs().data(), 4 * sizeof(double)); }
    void get(Pose& pose) {
        get(pose.position);
        get(pose.orientation);
    }
    template <typename T>
    void get(std::vector<T>& list) {
        list.resize(count(std::is_same_v<T, std::string> ? sizeof(std::uint64_t) : sizeof(T)));
        for (T& item : list) {
            get(item);
        }
    }
    void get(std::map<std::string, double>& map) {
        const std::size_t size = count(sizeof(std::uint64_t) + sizeof(double));
        for (std::size_t i = 0; i < size && ok_; ++i) {
            std::string name;
            get(name);
            get(map[name]);
        }
    }

    /// The length of a list whose items take at least `item_bytes` each; 0 and not ok when that many cannot follow.
    std::size_t count(std::size_t item_bytes) {
        std::uint64_t size = 0;
        get(size);
        if (!ok_ || size > (bytes_.size() - next_) / item_bytes) {
            ok_ = false;
            return 0;
        }
        return static_cast<std::size_t>(size);
    }

private:
    void get_raw(void* data, std::size_t size) {
        if (!ok_ || size > bytes_.size() - next_) {
            ok_ = false;
            std::memset(data, 0, size);
            return;
        }
        std::memcpy(data, bytes_.data() + next_, size);
        next_ += size;
    }

    std::string_view bytes_;
    std::size_t next_ = 0;
    bool ok_ = true;
};

}  // namespace rhexis
