#pragma once
/// Long work beside the interpreter: other threads of Python run meanwhile, and Ctrl-C ends the
/// work.

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>

namespace bindings {

/// The interpreter as the work knows it. All functions may be called from any thread.
class Caller {
  public:
    /// Throws app::Interrupted once Python wants the work to end: Ctrl-C, or an exception in a
    /// visit.
    void end_if_asked() const;
    /// Runs `visit` in the thread that called the work, with the interpreter's lock; waits for
    /// it.
    /// @throws app::Interrupted if Python wants the work to end
    void visit(const std::function<void()>& visit);

  private:
    friend void beside_python(const std::function<void(Caller&)>& work);
    void attend();
    void finish();
    void call_python(const std::function<void()>& what);

    std::mutex mutex_;
    std::condition_variable changed_;
    const std::function<void()>* visit_ = nullptr;
    bool finished_ = false;
    std::atomic<bool> ended_ = false;
    std::exception_ptr error_; ///< of Python
};

/// Runs the work in a thread of its own, without the interpreter's lock. The calling thread,
/// which has the lock before and after, looks for signals meanwhile.
/// @throws what Python wants to raise, such as KeyboardInterrupt; else what the work throws
void beside_python(const std::function<void(Caller&)>& work);

/// While it lives, this thread of Python alone may use HDF5, which serves one thread at a time.
class Hdf5Turn {
  public:
    /// @throws std::runtime_error if another thread has it
    Hdf5Turn();
    ~Hdf5Turn();
    Hdf5Turn(const Hdf5Turn&) = delete;
    Hdf5Turn& operator=(const Hdf5Turn&) = delete;

  private:
    bool mine_ = false; ///< not of an outer turn of the same thread
};

} // namespace bindings
