// SPDX-License-Identifier: GPL-3.0-or-later
// Storage that whole vector registers can be loaded from: it starts at a line of the cache.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace rhexis {

template <typename T>
struct Aligned {
    using value_type = T;
    Aligned() = default;
    template <typename U>
    explicit Aligned(const Aligned<U>& /*other*/) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64})); }
    void deallocate(T* p, std::size_t /*n*/) { ::operator delete (p, std::align_val_t{64}); }
    friend bool operator==(const Aligned& /*a*/, const Aligned& /*b*/) { return true; }
};
template <typename T>
using AlignedVector = std::vector<T, Aligned<T>>;

}  // namespace rhexis
