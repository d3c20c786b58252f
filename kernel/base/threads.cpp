// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/threads.hpp"

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "base/assert.hpp"

namespace rhexis {

namespace {

constexpr std::uint32_t closed = 0xffffffffU;

std::uint32_t round_of(std::uint64_t ticket) { return static_cast<std::uint32_t>(ticket >> 32U); }
std::uint32_t chunk_of(std::uint64_t ticket) { return static_cast<std::uint32_t>(ticket); }
std::uint64_t ticket_of(std::uint32_t round, std::uint32_t chunk) {
    return (static_cast<std::uint64_t>(round) << 32U) | chunk;
}

}  // namespace

// To wake a thread takes as long as some of the work does. So the caller waits for chunks that were begun, never for a
// helper that has yet to wake up: that one finds the round over.
struct ThreadPool::Shared {
    std::atomic<std::uint64_t> next{ticket_of(0, closed)};  ///< to be taken: a chunk of a round that is over cannot be
    std::atomic<const std::function<void(int)>*> work{nullptr};
    std::atomic<std::uint32_t> chunks{0};
    std::atomic<std::uint32_t> done{0};
    std::atomic<std::uint32_t> round{0};  ///< to sleep on
    std::atomic<bool> stop{false};
    std::vector<std::thread> helpers;

    void drain() {
        std::uint64_t ticket = next.load();
        while (true) {
            // What is read here belongs to the ticket if that can still be taken: a round is closed before the next
            // one's work is written.
            const std::function<void(int)>* const task = work.load();
            if (chunk_of(ticket) >= chunks.load()) {
                return;
            }
            if (next.compare_exchange_weak(ticket, ticket + 1)) {
                (*task)(static_cast<int>(chunk_of(ticket)));
                done.fetch_add(1);
                ticket = next.load();
            }
        }
    }

    void help() {
        while (!stop.load()) {
            const std::uint32_t seen = round.load();
            drain();
            round.wait(seen);
        }
    }

    void begin_round() {
        round.fetch_add(1);
        round.notify_all();
    }
};

ThreadPool::ThreadPool(int threads) : shared_(std::make_unique<Shared>()) {
    RHEXIS_ASSERT(threads >= 1 && threads <= 64);
    for (int i = 1; i < threads; ++i) {
        shared_->helpers.emplace_back([this] { shared_->help(); });
    }
}

ThreadPool::~ThreadPool() {
    shared_->stop = true;
    shared_->begin_round();
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
    const std::uint32_t round = round_of(shared_->next.load());
    shared_->next = ticket_of(round, closed);
    shared_->work = &work;
    shared_->chunks = static_cast<std::uint32_t>(chunks);
    shared_->done = 0;
    shared_->next = ticket_of(round + 1, 0);
    shared_->begin_round();
    shared_->drain();
    while (shared_->done.load() < static_cast<std::uint32_t>(chunks)) {
        std::this_thread::yield();
    }
}

}  // namespace rhexis
