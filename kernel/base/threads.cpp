// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/threads.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "base/assert.hpp"

namespace rhexis {

struct ThreadPool::Shared {
    std::mutex mutex;
    std::condition_variable wake;
    std::condition_variable done;
    const std::function<void(int)>* work = nullptr;
    int chunks = 0;
    std::atomic<int> next{0};
    int busy = 0;
    unsigned long round = 0;
    bool stop = false;
    std::vector<std::thread> helpers;

    void drain() {
        for (int chunk = next.fetch_add(1); chunk < chunks; chunk = next.fetch_add(1)) {
            (*work)(chunk);
        }
    }

    void help() {
        unsigned long seen = 0;
        std::unique_lock lock(mutex);
        while (true) {
            wake.wait(lock, [&] { return stop || round != seen; });
            if (stop) {
                return;
            }
            seen = round;
            lock.unlock();
            drain();
            lock.lock();
            if (--busy == 0) {
                done.notify_one();
            }
        }
    }
};

ThreadPool::ThreadPool(int threads) : shared_(std::make_unique<Shared>()) {
    RHEXIS_ASSERT(threads >= 1 && threads <= 64);
    for (int i = 1; i < threads; ++i) {
        shared_->helpers.emplace_back([this] { shared_->help(); });
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->stop = true;
    }
    shared_->wake.notify_all();
    for (std::thread& helper : shared_->helpers) {
        helper.join();
    }
}

int ThreadPool::threads() const { return static_cast<int>(shared_->helpers.size()) + 1; }

void ThreadPool::for_each_chunk(int chunks, const std::function<void(int)>& work) {
    if (shared_->helpers.empty() || chunks <= 1) {
        for (int chunk = 0; chunk < chunks; ++chunk) {
            work(chunk);
        }
        return;
    }
    std::unique_lock lock(shared_->mutex);
    shared_->work = &work;
    shared_->chunks = chunks;
    shared_->next = 0;
    shared_->busy = static_cast<int>(shared_->helpers.size());
    ++shared_->round;
    lock.unlock();
    shared_->wake.notify_all();
    shared_->drain();
    lock.lock();
    shared_->done.wait(lock, [this] { return shared_->busy == 0; });
}

}  // namespace rhexis
