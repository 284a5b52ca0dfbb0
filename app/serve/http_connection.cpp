#include "app/serve/http_connection.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace app {
namespace {

constexpr int kLook = 100;                // [ms] between looks whether the server ends
constexpr std::size_t kAtOnce = 16 << 10; // [byte] asked of the system
constexpr auto kGoodbye =
    std::chrono::seconds(1); // for bytes on their way after the last answer

bool is_ready(socket_t socket, short event, int milliseconds)
{
    pollfd look{socket, event, 0};
    return ::poll(&look, 1, milliseconds) > 0;
}

} // namespace

HttpConnection::HttpConnection(socket_t socket, const ConnectionLimits& limits,
                               const std::function<bool()>& ended)
    : socket_(socket), limits_(limits), ended_(ended)
{
}

bool HttpConnection::wait_for(short event) const
{
    const auto end = Clock::now() + std::chrono::seconds(limits_.silent_seconds);
    while (!is_ready(socket_, event, kLook))
        if (ended_() || Clock::now() > end) return false;
    return true;
}

/// @return false: nothing came, or the other side is done
bool HttpConnection::fill()
{
    if (!wait_for(POLLIN)) return false;
    buffer_.resize(kAtOnce);
    ssize_t got = 0;
    do got = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    while (got < 0 && errno == EINTR);
    buffer_.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    at_ = 0;
    return got > 0;
}

bool HttpConnection::next_request()
{
    in_head_ = true;
    head_bytes_ = line_bytes_ = 0;
    head_begin_ = Clock::now();
    return at_ < buffer_.size() || fill();
}

/// Follows the lines of a head, which ends with an empty one.
/// @return false: it is too long, or takes too long
bool HttpConnection::head_goes_on(char byte)
{
    ++line_bytes_;
    const bool line_ends = byte == '\n' && last_ == '\r';
    in_head_ = !(line_ends && line_bytes_ == 2);
    if (line_ends) line_bytes_ = 0;
    last_ = byte;
    const std::chrono::duration<double> taken = Clock::now() - head_begin_;
    return ++head_bytes_ <= limits_.most_head_bytes &&
           taken.count() <= limits_.most_head_seconds;
}

ssize_t HttpConnection::read(char* to, std::size_t size)
{
    const ssize_t n = taken(to, size);
    broken_ = broken_ || n <= 0;
    return n;
}

/// @return how many bytes; 0: none came; -1: the head is beyond its limits
ssize_t HttpConnection::taken(char* to, std::size_t size)
{
    if (at_ == buffer_.size() && !fill()) return 0;
    if (in_head_) { // byte by byte: the library reads it so
        if (!head_goes_on(buffer_[at_])) return -1;
        *to = buffer_[at_++];
        return 1;
    }
    const std::size_t n = std::min(size, buffer_.size() - at_);
    std::memcpy(to, buffer_.data() + at_, n);
    at_ += n;
    return static_cast<ssize_t>(n);
}

ssize_t HttpConnection::write(const char* from, std::size_t size)
{
    const auto end = Clock::now() + std::chrono::seconds(limits_.silent_seconds);
    while (!is_ready(socket_, POLLOUT, kLook))
        if (Clock::now() > end) return -1; // not asked to end: answers under way go out
    return ::send(socket_, from, size, MSG_NOSIGNAL);
}

bool HttpConnection::is_readable() const { return at_ < buffer_.size() || wait_for(POLLIN); }

bool HttpConnection::is_writable() const { return is_ready(socket_, POLLOUT, kLook); }

void HttpConnection::say_goodbye()
{
    ::shutdown(socket_, SHUT_WR);
    const auto end = Clock::now() + kGoodbye;
    std::string rest(kAtOnce, '\0');
    while (Clock::now() < end && !ended_())
        if (is_ready(socket_, POLLIN, kLook) &&
            ::recv(socket_, rest.data(), rest.size(), 0) <= 0)
            return;
}

} // namespace app
