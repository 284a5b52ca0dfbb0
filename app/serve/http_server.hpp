#pragma once
/// HTTP for umbridge.hpp. The HTTP library is known to http_server.cpp and http_connection.hpp
/// alone.

#include "app/serve/request_head.hpp"
#include "app/serve/umbridge.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace app {

struct HttpOptions {
    ServerNames names; ///< names.address is that of this machine at which it listens
    int port = 4242;   ///< 0: any free one
    /// Largest size of a request [byte]. A wall with ten thousand joints has half a million.
    std::size_t most_bytes = 8 << 20;
    std::size_t most_head_bytes = 64 << 10; ///< of a request: its first line and its headers
    double most_seconds =
        10.0; ///< in which the head of a request, and its body, have to arrive [s]
    int silent_seconds = 5; ///< longest silence within a request [s]
    int connections = 128;  ///< served at a time; further ones wait
};

/// Answers until `ended` says so; then requests that wait for a wall get an error. Requests
/// outside the limits get one, too.
/// @param listening is told the port
/// @param ended is asked every tenth of a second
/// @throws std::runtime_error if it cannot listen there
void serve_http(const HttpOptions& options, std::span<const ServedModel> models,
                const std::function<void(int port)>& listening,
                const std::function<bool()>& ended);

} // namespace app
