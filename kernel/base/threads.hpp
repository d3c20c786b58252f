// SPDX-License-Identifier: GPL-3.0-or-later
// Work cut into a fixed number of chunks, so that results do not depend on how many threads run them.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

namespace rhexis {

/// A pool of helper threads. With one thread everything runs on the caller.
class ThreadPool {
public:
    /// threads in [1, 64]: the caller and threads - 1 helpers.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    [[nodiscard]] int threads() const;

    /// Runs work(chunk) once for each chunk in [0, chunks) and returns when all are done. Which thread runs which
    /// chunk is undefined; sums over chunks must be taken by the caller, in chunk order.
    void for_each_chunk(int chunks, const std::function<void(int)>& work);

private:
    struct Shared;
    std::unique_ptr<Shared> shared_;
};

/// Into how many ranges so much work is cut: one with one thread, or where there is little to do.
inline int ranges_of(const ThreadPool& pool, int count) {
    constexpr int ranges_a_thread = 4;  // so that an uneven one does not keep the others waiting
    constexpr int least = 32;           // less is done before it is handed out
    return pool.threads() == 1 ? 1 : std::clamp(count / least, 1, ranges_a_thread * pool.threads());
}

/// Runs work(first, last, range) over [0, count), cut into ranges that are numbered from 0.
template <class Work>
void for_each_range(ThreadPool& pool, int count, const Work& work) {
    const int ranges = ranges_of(pool, count);
    pool.for_each_chunk(ranges, [&](int range) {
        const auto bound = [&](long k) { return static_cast<int>(k * count / ranges); };
        work(bound(range), bound(range + 1L), range);
    });
}

/// Appends to `all` what find(first, last, found) finds among [0, count), in order. What it finds must not depend on
/// where its range begins and ends: then it does not depend on threads.
template <class Found, class Find>
void gather(ThreadPool& pool, int count, std::vector<Found>& all, const Find& find) {
    if (pool.threads() == 1) {
        find(0, count, all);
        return;
    }
    std::vector<std::vector<Found>> found(static_cast<std::size_t>(ranges_of(pool, count)));
    for_each_range(pool, count,
                   [&](int first, int last, int range) { find(first, last, found[static_cast<std::size_t>(range)]); });
    for (const std::vector<Found>& part : found) {
        all.insert(all.end(), part.begin(), part.end());
    }
}

}  // namespace rhexis
