#pragma once
/// One thread needs no lock: Boost 1.74 asks for std::mutex, which is not there.

namespace boost::detail {

struct lightweight_mutex {
    struct scoped_lock {
        explicit scoped_lock(lightweight_mutex&) {}
    };
};

} // namespace boost::detail
