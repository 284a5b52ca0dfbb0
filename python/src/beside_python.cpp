#include "python/src/beside_python.hpp"

#include "app/study/pushed/interrupt.hpp"

#include <pybind11/pybind11.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace bindings {
namespace {

constexpr auto kLook = std::chrono::milliseconds(50); // between looks for Ctrl-C

std::atomic<std::thread::id> hdf5_thread{};

} // namespace

void Caller::end_if_asked() const
{
    if (ended_) throw app::Interrupted();
}

void Caller::visit(const std::function<void()>& visit)
{
    end_if_asked();
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return visit_ == nullptr; });
        visit_ = &visit;
        changed_.notify_all();
        changed_.wait(lock, [&] { return visit_ != &visit; });
    }
    end_if_asked();
}

void Caller::call_python(const std::function<void()>& what)
{
    const pybind11::gil_scoped_acquire lock;
    try {
        what();
        if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    } catch (...) {
        if (!error_) error_ = std::current_exception();
        ended_ = true;
    }
}

void Caller::attend()
{
    std::unique_lock lock(mutex_);
    while (!finished_) {
        changed_.wait_for(lock, kLook, [&] { return visit_ != nullptr || finished_; });
        const std::function<void()>* const asked = visit_;
        lock.unlock();
        call_python([&] {
            if (asked != nullptr && !ended_) (*asked)();
        });
        lock.lock();
        if (asked == nullptr) continue;
        visit_ = nullptr;
        changed_.notify_all();
    }
}

void Caller::finish()
{
    const std::lock_guard lock(mutex_);
    finished_ = true;
    changed_.notify_all();
}

void beside_python(const std::function<void(Caller&)>& work)
{
    Caller caller;
    std::exception_ptr trouble;
    {
        const pybind11::gil_scoped_release free;
        const std::jthread worker([&] {
            try {
                work(caller);
            } catch (...) {
                trouble = std::current_exception();
            }
            caller.finish();
        });
        caller.attend();
    }
    if (caller.error_) std::rethrow_exception(caller.error_);
    if (trouble) std::rethrow_exception(trouble);
}

Hdf5Turn::Hdf5Turn()
{
    std::thread::id owner{};
    mine_ = hdf5_thread.compare_exchange_strong(owner, std::this_thread::get_id());
    if (!mine_ && owner != std::this_thread::get_id())
        throw std::runtime_error(
            "another thread runs or opens a study, and HDF5 serves one thread "
            "at a time; wait for it, or use processes");
}

Hdf5Turn::~Hdf5Turn()
{
    if (mine_) hdf5_thread = std::thread::id{};
}

} // namespace bindings
