#pragma once
/// One connection of the HTTP server, within its limits. The library's own has no bound on the
/// lines of a request's head, gives no answer to a client that has shut its sending side, and
/// waits for silent clients when the server ends.

#include <httplib.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace app {

struct ConnectionLimits {
    std::size_t most_head_bytes = 64 << 10; ///< request line and headers
    double most_head_seconds = 10.0;        ///< in which they have to arrive
    int silent_seconds = 5;                 ///< longest silence of either side
};

class HttpConnection final : public httplib::Stream {
  public:
    /// @param socket is open; it is closed by who calls
    /// @param ended whether the server is told to end, asked every tenth of a second
    HttpConnection(socket_t socket, const ConnectionLimits& limits,
                   const std::function<bool()>& ended);

    /// Waits for a request, which begins with the next byte.
    /// @return false: there is none
    [[nodiscard]] bool next_request();
    /// Whether what was asked for did not come, so that what follows on this connection is no
    /// request.
    [[nodiscard]] bool is_broken() const { return broken_; }
    /// Lets the client read what was sent before the socket is closed: closing it on bytes that
    /// were not read would withdraw the answer.
    void say_goodbye();

    [[nodiscard]] bool is_readable() const override;
    [[nodiscard]] bool is_writable() const override;
    ssize_t read(char* to, std::size_t size) override;
    ssize_t write(const char* from, std::size_t size) override;
    void get_remote_ip_and_port(std::string&, int&) const override {}
    void get_local_ip_and_port(std::string&, int&) const override {}
    [[nodiscard]] socket_t socket() const override { return socket_; }

  private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool wait_for(short event) const;
    [[nodiscard]] bool fill();
    [[nodiscard]] bool head_goes_on(char byte);
    [[nodiscard]] ssize_t taken(char* to, std::size_t size);

    socket_t socket_;
    const ConnectionLimits& limits_;
    const std::function<bool()>& ended_;
    std::string buffer_;
    std::size_t at_ = 0; ///< what is read of the buffer
    bool in_head_ = false, broken_ = false;
    std::size_t head_bytes_ = 0, line_bytes_ = 0;
    char last_ = 0;
    Clock::time_point head_begin_;
};

} // namespace app
