// SPDX-License-Identifier: GPL-3.0-or-later
// Work cut into a fixed number of chunks, so that results do not depend on how many threads run them.
#pragma once

#include <functional>
#include <memory>

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

}  // namespace rhexis
